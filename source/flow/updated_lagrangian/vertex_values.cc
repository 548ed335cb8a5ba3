#include <deal.II/base/mpi.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/vertex_values.h>

namespace Sandglass
{
  namespace
  {
    /// Call `function(index among the vertices' values, degree of freedom)` for
    /// the degrees of freedom that this rank owns, for some more than once.
    template <int dim, typename Function>
    void
    for_each_owned_value(const ElementGrid<dim> &grid, const Function &function)
    {
      for (const auto &cell : grid.dof_handler.active_cell_iterators())
        if (!cell->is_artificial())
          for (const unsigned int v : cell->vertex_indices())
            for (unsigned int d = 0; d < dim; ++d)
              {
                const auto dof = cell->vertex_dof_index(v, d);
                if (grid.owned_dofs.is_element(dof))
                  function(dim * cell->vertex_index(v) + d, dof);
              }
    }
  } // namespace



  template <int dim>
  std::vector<double>
  values_at_vertices(const ElementGrid<dim>   &grid,
                     const DisplacementVector &vector)
  {
    std::vector<double> values(dim * grid.triangulation.n_vertices(), 0.);
    for_each_owned_value(grid, [&](const unsigned int i, const auto dof) {
      values[i] = vector[dof];
    });
    // All ranks but the owner have zero.
    Utilities::MPI::sum(values, grid.triangulation.get_communicator(), values);
    return values;
  }



  template <int dim>
  DisplacementVector
  vector_of_values(const ElementGrid<dim>    &grid,
                   const std::vector<double> &values_at_vertices)
  {
    DisplacementVector vector = grid.make_vector();
    vector.zero_out_ghost_values();
    for_each_owned_value(grid, [&](const unsigned int i, const auto dof) {
      vector[dof] = values_at_vertices[i];
    });
    vector.update_ghost_values();
    return vector;
  }



#define INSTANTIATE(dim)                                                       \
  template std::vector<double> values_at_vertices(const ElementGrid<dim> &,    \
                                                  const DisplacementVector &); \
  template DisplacementVector  vector_of_values(const ElementGrid<dim> &,      \
                                                const std::vector<double> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
