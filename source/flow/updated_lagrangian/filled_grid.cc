#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/filled_grid.h>

namespace Sandglass
{
  template <int dim>
  FilledGrid<dim>::FilledGrid(const Scene<dim>  &scene,
                              const unsigned int element_order)
    : FilledGrid(scene, element_order, filled_part(scene.mesh))
  {}



  template <int dim>
  FilledGrid<dim>::FilledGrid(const Scene<dim>    &scene,
                              const unsigned int   element_order,
                              const MeshPart<dim> &part)
    : ElementGrid<dim>(part.mesh,
                       element_order,
                       scene.communicator,
                       [&](const unsigned int cell) {
                         return scene.cell_owners[part.cells[cell]];
                       })
    , scene_cells(part.cells)
    , scene_vertices(part.vertices)
  {}



#define INSTANTIATE(dim) template class FilledGrid<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
