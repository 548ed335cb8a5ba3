#include <sandglass/run/static_to_particles.h>

namespace Sandglass
{
  namespace
  {
    /// Index of the quadrature point next to a reference point.
    unsigned int
    nearest_quadrature_point(const CellType    cell_type,
                             const Point<dim> &reference_point)
    {
      return cell_type == CellType::triangle ?
               0 :
               (reference_point[0] > 0.5 ? 1 : 0) +
                 (reference_point[1] > 0.5 ? 2 : 0);
    }
  } // namespace



  void
  carry_to_particles(const StaticState &static_state,
                     ParticleStage     &stage,
                     const bool         displaces_particles)
  {
    const auto &element = *stage.scene.finite_element;
    stage.set_initial_state(
      [&](const unsigned int cell, const Point<dim> &reference_point) {
        const auto        &state = static_state.cells[cell];
        const unsigned int q =
          nearest_quadrature_point(stage.scene.mesh.cell_type, reference_point);
        ParticleStage::InitialState initial{{},
                                            state.stress[q],
                                            state.volume_ratio[q]};
        if (displaces_particles)
          for (unsigned int i = 0; i < element.n_dofs_per_cell(); ++i)
            initial.displacement +=
              element.shape_value(i, reference_point) * state.displacement[i];
        return initial;
      });
    stage.contact.start_from(static_state.wall_forces);
  }
} // namespace Sandglass
