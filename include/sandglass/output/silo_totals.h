#ifndef sandglass_output_silo_totals_h
#define sandglass_output_silo_totals_h

#include <sandglass/flow/flow_view.h>

namespace Sandglass
{
  /**
   * Totals of the whole silo: where the scene is half of a symmetric section,
   * twice the grid's, except for the horizontal momentum, which vanishes in the
   * whole.
   */
  struct SiloTotals : FlowTotals
  {
    /// All zero.
    SiloTotals() = default;

    /// @param symmetry_factor  see Scene.
    SiloTotals(const FlowTotals &of_grid, const double symmetry_factor)
      : FlowTotals(of_grid)
    {
      for (double *sum : {&mass_in_silo,
                          &mass_falling,
                          &mass_removed,
                          &mass_lost,
                          &mass_fed,
                          &kinetic_energy,
                          &elastic_energy,
                          &dissipated_energy,
                          &wall_work,
                          &momentum[1],
                          &momentum[2]})
        *sum *= symmetry_factor;
      for (double &mass : mass_by_outlet)
        mass *= symmetry_factor;
    }

    /// All that has passed the outlet level, in kg.
    double
    mass_discharged() const
    {
      return mass_falling + mass_removed;
    }

    double
    mass() const
    {
      return mass_in_silo + mass_discharged() + mass_lost;
    }
  };
} // namespace Sandglass

#endif
