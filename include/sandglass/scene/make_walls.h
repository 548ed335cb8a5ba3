#ifndef sandglass_scene_make_walls_h
#define sandglass_scene_make_walls_h

#include <sandglass/continuum/formulation.h>
#include <sandglass/scene/mesh.h>
#include <sandglass/walls/wall.h>
#include <sandglass/walls/wall_parameters.h>

#include <vector>

namespace Sandglass
{
  /**
   * The walls that a mesh has, with their friction and motion: the standard
   * parts, then the named walls.
   *
   * Throws InputError where a boundary face belongs to a named wall without
   * friction angle, where the parameters name a wall that the mesh lacks, or
   * where a wall would leave its plane.
   *
   * @param boundary_ids  of the boundary faces of the mesh's triangulation.
   */
  template <int dim>
  std::vector<Wall<dim>>
  make_walls(const Mesh<dim>                               &mesh,
             const std::vector<dealii::types::boundary_id> &boundary_ids,
             const Formulation                              formulation,
             const WallParameters                          &parameters);

  /**
   * Drop those faces of named walls that belong to a standard part too, and
   * give the others their role, which the directions of all faces of a wall
   * decide: wall if they are vertical, floor if horizontal, hopper if neither,
   * insert if some are and some are not.
   */
  template <int dim>
  void
  settle_named_walls(Mesh<dim> &mesh);
} // namespace Sandglass

#endif
