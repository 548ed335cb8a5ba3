#include <sandglass/choices.h>
#include <sandglass/run/static_to_particles.h>

namespace Sandglass
{
  namespace
  {
    /// Index of the quadrature point next to a reference point.
    template <int dim>
    unsigned int
    nearest_quadrature_point(const CellType    cell_type,
                             const Point<dim> &reference_point)
    {
      unsigned int q = 0;
      if (!is_simplex(cell_type))
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
    const auto &element = *scene.finite_element;
    flow.start_from(
      [&](const unsigned int cell, const Point<dim> &reference_point) {
        const auto        &state = static_state.cells[cell];
        const unsigned int q =
          nearest_quadrature_point(scene.mesh.cell_type, reference_point);
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
