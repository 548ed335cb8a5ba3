#include <sandglass/scene/mesh_size.h>

#include <gmsh.h>

namespace Sandglass
{
  void
  grade_mesh_size(const std::vector<int> &points,
                  const double            size_at_points,
                  const double            largest_size)
  {
    namespace Field    = gmsh::model::mesh::field;
    const int distance = Field::add("Distance");
    Field::setNumbers(distance, "PointsList", {points.begin(), points.end()});

    const int size = Field::add("Threshold");
    Field::setNumber(size, "InField", distance);
    Field::setNumber(size, "DistMin", 0.);
    Field::setNumber(size,
                     "DistMax",
                     (largest_size - size_at_points) / mesh_size_growth);
    Field::setNumber(size, "SizeMin", size_at_points);
    Field::setNumber(size, "SizeMax", largest_size);
    Field::setAsBackgroundMesh(size);

    // Otherwise the sizes at points and on the boundary count as well.
    gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
    gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  }
} // namespace Sandglass
