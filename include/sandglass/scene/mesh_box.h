#ifndef sandglass_scene_mesh_box_h
#define sandglass_scene_mesh_box_h

#include <sandglass/scene/mesh.h>

#include <limits>
#include <string>
#include <vector>

namespace Sandglass
{
  /// The box around some of a mesh's vertices, in m.
  template <int dim>
  struct MeshBox
  {
    MeshBox()
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] = std::numeric_limits<double>::infinity();
          upper[d] = -std::numeric_limits<double>::infinity();
        }
    }

    void
    add(const dealii::Point<dim> &point);

    bool
    is_empty() const
    {
      return lower[0] > upper[0];
    }

    dealii::Point<dim> lower, upper;
  };

  template <int dim>
  MeshBox<dim>
  box_of_cells(const Mesh<dim> &mesh, const bool only_filled);

  template <int dim>
  MeshBox<dim>
  box_of_face(const Mesh<dim> &mesh, const typename Mesh<dim>::Face &face);

  /// Around all faces of a role.
  template <int dim>
  MeshBox<dim>
  box_of_role(const Mesh<dim> &mesh, const BoundaryRole role);

  /// Coordinates that are closer than this are the same, in m.
  template <int dim>
  double
  rounding(const Mesh<dim> &mesh);

  /**
   * y of the outlet's lowest point in m; of the material's without an outlet.
   *
   * @param warnings  takes that material lies below it. Throws InputError where
   *                  that can't be meant.
   */
  template <int dim>
  double
  find_outlet_level(const Mesh<dim> &mesh, std::vector<std::string> &warnings);
} // namespace Sandglass

#endif
