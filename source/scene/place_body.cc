#include <sandglass/base/exceptions.h>
#include <sandglass/scene/body_cells.h>
#include <sandglass/scene/mesh_box.h>
#include <sandglass/scene/mesh_cells.h>
#include <sandglass/scene/place_mesh.h>
#include <sandglass/walls/face_geometry.h>

#include <cmath>
#include <optional>

namespace Sandglass
{
  namespace
  {
    /// x and z of the symmetry planes, if there are any.
    std::array<std::optional<double>, 3>
    find_symmetry_planes(const Mesh<3> &mesh)
    {
      const double                         distance = rounding(mesh);
      const MeshBox<3>                     cells    = box_of_cells(mesh, false);
      std::array<std::optional<double>, 3> planes;
      for (const auto &face : mesh.faces)
        {
          if (face.role != BoundaryRole::axis)
            continue;
          const MeshBox<3> box     = box_of_face(mesh, face);
          const auto       lies_in = [&](const unsigned int d) {
            return box.upper[d] - box.lower[d] <= distance &&
                   (!planes[d] ||
                    std::abs(box.lower[d] - *planes[d]) <= 2. * distance);
          };
          const unsigned int d = lies_in(0) ? 0 : 2;
          if (!lies_in(d))
            throw InputError("a face of the physical group 'axis', from " +
                             place(box.lower) + " to " + place(box.upper) +
                             ", lies in no symmetry plane; allowed are one "
                             "plane x = constant and one z = constant");
          planes[d] = box.lower[d];
          if (cells.lower[d] < *planes[d] - distance &&
              cells.upper[d] > *planes[d] + distance)
            throw InputError(
              "the mesh has cells on both sides of the physical group 'axis' "
              "at " +
              place(box.lower) +
              "; allowed is a half or a quarter that ends there, or a whole "
              "silo without symmetry planes");
        }
      return planes;
    }
  } // namespace



  template <>
  void
  place_mesh<3>(Mesh<3> &mesh,
                const Formulation,
                std::vector<std::string> &warnings)
  {
    const double distance = rounding(mesh);
    const auto   planes   = find_symmetry_planes(mesh);
    const double level    = find_outlet_level(mesh, warnings);
    // Rounded coordinates are left as they are.
    dealii::Tensor<1, 3> shift;
    for (const unsigned int d : {0u, 2u})
      if (planes[d] && std::abs(*planes[d]) > distance)
        shift[d] = -*planes[d];
    if (std::abs(level) > distance)
      shift[1] = -level;
    if (shift.norm() > 0.)
      {
        for (Point<3> &vertex : mesh.vertices)
          vertex += shift;
        warnings.push_back(
          "The mesh has been moved by " + place(Point<3>(shift)) +
          ", so that symmetry planes are at x = 0 and z = 0 and the outlet "
          "level at y = 0; positions in the results are those after the move.");
      }
    // A symmetry plane goes on below the outlet, where particles must not pass.
    for (auto &face : mesh.faces)
      if (is_open(face.role))
        for (const unsigned int d : {0u, 2u})
          if (const MeshBox<3> box = box_of_face(mesh, face);
              planes[d] && std::abs(box.lower[d]) < distance &&
              std::abs(box.upper[d]) < distance)
            face.role = BoundaryRole::axis;
    order_faces(mesh);
  }
} // namespace Sandglass
