#ifndef sandglass_flow_updated_lagrangian_filled_grid_h
#define sandglass_flow_updated_lagrangian_filled_grid_h

#include <sandglass/flow/updated_lagrangian/element_grid.h>
#include <sandglass/scene/scene.h>

namespace Sandglass
{
  /**
   * The part of the Scene that material fills at the start, as a grid of its
   * own. It is partitioned as the Scene is, so that results go back to the
   * Scene's cells without communication.
   */
  template <int dim>
  class FilledGrid : public ElementGrid<dim>
  {
  public:
    /// @param element_order  see ElementGrid.
    explicit FilledGrid(const Scene<dim>  &scene,
                        const unsigned int element_order = 1);

    /// Index in the Scene of each active cell and vertex.
    const std::vector<unsigned int> scene_cells, scene_vertices;

  private:
    FilledGrid(const Scene<dim>    &scene,
               const unsigned int   element_order,
               const MeshPart<dim> &part);
  };
} // namespace Sandglass

#endif
