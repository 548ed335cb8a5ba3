#ifndef sandglass_flow_updated_lagrangian_match_vertices_h
#define sandglass_flow_updated_lagrangian_match_vertices_h

#include <deal.II/grid/tria_accessor.h>

#include <array>

namespace Sandglass
{
  using namespace dealii;

  /**
   * For each vertex of `cell` the number that it has in `same_cell` of
   * another triangulation. deal.II orients quadrilaterals by their
   * neighbours, so that it need not be the same.
   */
  template <int dim>
  std::array<unsigned int, 1u << dim>
  match_vertices(const CellAccessor<dim> &cell,
                 const CellAccessor<dim> &same_cell)
  {
    std::array<unsigned int, 1u << dim> result{};
    for (const unsigned int v : cell.vertex_indices())
      {
        unsigned int w = 0;
        while (w < cell.n_vertices() && same_cell.vertex(w) != cell.vertex(v))
          ++w;
        Assert(w < cell.n_vertices(), ExcInternalError());
        result[v] = w;
      }
    return result;
  }
} // namespace Sandglass

#endif
