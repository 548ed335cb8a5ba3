#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/mesh_box.h>

#include <algorithm>
#include <sstream>

namespace Sandglass
{
  template <int dim>
  void
  MeshBox<dim>::add(const dealii::Point<dim> &point)
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = std::min(lower[d], point[d]);
        upper[d] = std::max(upper[d], point[d]);
      }
  }



  template <int dim>
  MeshBox<dim>
  box_of_cells(const Mesh<dim> &mesh, const bool only_filled)
  {
    MeshBox<dim> box;
    for (const auto &cell : mesh.cells)
      if (cell.is_filled || !only_filled)
        for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
          box.add(mesh.vertices[cell.vertices[v]]);
    return box;
  }



  template <int dim>
  MeshBox<dim>
  box_of_face(const Mesh<dim> &mesh, const typename Mesh<dim>::Face &face)
  {
    MeshBox<dim> box;
    for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
      box.add(mesh.vertices[face.vertices[v]]);
    return box;
  }



  template <int dim>
  MeshBox<dim>
  box_of_role(const Mesh<dim> &mesh, const BoundaryRole role)
  {
    MeshBox<dim> box;
    for (const auto &face : mesh.faces)
      if (face.role == role)
        for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
          box.add(mesh.vertices[face.vertices[v]]);
    return box;
  }



  template <int dim>
  double
  rounding(const Mesh<dim> &mesh)
  {
    const MeshBox<dim> box = box_of_cells(mesh, false);
    return 1e-8 * box.lower.distance(box.upper);
  }



  template <int dim>
  double
  find_outlet_level(const Mesh<dim> &mesh, std::vector<std::string> &warnings)
  {
    const MeshBox<dim> outlet   = box_of_role(mesh, BoundaryRole::outlet);
    const MeshBox<dim> material = box_of_cells(mesh, true);
    const double       level =
      outlet.is_empty() ? material.lower[1] : outlet.lower[1];
    if (material.lower[1] >= level - rounding(mesh))
      return level;

    std::ostringstream message;
    message << "material lies below the outlet: it reaches down to y = "
            << material.lower[1] << " m, the outlet to y = " << level << " m";
    // Who fills the fall region, too, means it.
    if (std::any_of(mesh.cells.begin(), mesh.cells.end(), [](const auto &cell) {
          return !cell.is_filled;
        }))
      throw InputError(message.str() +
                       "; allowed is an outlet at the material's lowest "
                       "level");
    warnings.push_back("What is below the outlet counts as discharged from "
                       "the start: " +
                       message.str() + '.');
    return level;
  }



#define INSTANTIATE(dim)                                                    \
  template struct MeshBox<dim>;                                             \
  template MeshBox<dim> box_of_cells<dim>(const Mesh<dim> &, const bool);   \
  template MeshBox<dim> box_of_face<dim>(const Mesh<dim> &,                 \
                                         const typename Mesh<dim>::Face &); \
  template MeshBox<dim> box_of_role<dim>(const Mesh<dim> &,                 \
                                         const BoundaryRole);               \
  template double       rounding<dim>(const Mesh<dim> &);                   \
  template double       find_outlet_level<dim>(const Mesh<dim> &,           \
                                         std::vector<std::string> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
