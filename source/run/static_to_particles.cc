#include <deal.II/fe/fe_simplex_p.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/run/static_to_particles.h>

#include <numeric>

namespace Sandglass
{
  namespace
  {
    /// Index of the quadrature point next to a reference point.
    template <int dim>
    unsigned int
    nearest_quadrature_point(const CellType     cell_type,
                             const unsigned int element_order,
                             const Point<dim>  &reference_point)
    {
      unsigned int q = 0;
      // Each of a quadratic triangle's three points has a vertex of its own.
      if (element_order == 2)
        {
          double nearest = 1. - std::accumulate(reference_point.begin_raw(),
                                                reference_point.end_raw(),
                                                0.);
          for (unsigned int d = 0; d < dim; ++d)
            if (reference_point[d] > nearest)
              {
                nearest = reference_point[d];
                q       = d + 1;
              }
        }
      else if (!is_simplex(cell_type))
        for (unsigned int d = 0; d < dim; ++d)
          q += reference_point[d] > 0.5 ? 1u << d : 0u;
      return q;
    }
  } // namespace



  template <int dim>
  void
  carry_to_particles(const StaticState<dim> &static_state,
                     const Scene<dim>       &scene,
                     DynamicFlow<dim>       &flow,
                     const bool              displaces_particles)
  {
    const FE_SimplexP<dim>    quadratic(2);
    const FiniteElement<dim> *own = scene.finite_element.get();
    const FiniteElement<dim> &element =
      static_state.element_order == 2 ? quadratic : *own;
    flow.start_from(
      [&](const unsigned int cell, const Point<dim> &reference_point) {
        const auto        &state = static_state.cells[cell];
        const unsigned int q =
          nearest_quadrature_point(scene.mesh.cell_type,
                                   static_state.element_order,
                                   reference_point);
        InitialState<dim> initial{{},
                                  state.stress[q],
                                  state.volume_ratio[q],
                                  state.law_state[q]};
        if (displaces_particles)
          for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
            initial.displacement +=
              element.shape_value(i, reference_point) * state.displacement[i];
        return initial;
      },
      static_state.wall_forces);
  }



#define INSTANTIATE(dim)                                     \
  template void carry_to_particles(const StaticState<dim> &, \
                                   const Scene<dim> &,       \
                                   DynamicFlow<dim> &,       \
                                   const bool);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
