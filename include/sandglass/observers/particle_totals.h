#ifndef sandglass_observers_particle_totals_h
#define sandglass_observers_particle_totals_h

#include <sandglass/particle_stage/particle_stage.h>

namespace Sandglass
{
  /**
   * Sums over all particles of all ranks at one time. They are those of the
   * whole silo: where the scene is half of a symmetric section, twice the
   * scene's, except for the horizontal momentum, which vanishes in the whole.
   * In plane strain, all are per metre of depth.
   */
  struct ParticleTotals
  {
    /// All zero.
    ParticleTotals() = default;

    /// Collective.
    ParticleTotals(ParticleStage &stage, const Elasticity &elasticity);

    unsigned long n_particles    = 0;
    unsigned long particle_steps = 0; ///< since this process started

    double mass_in_silo = 0.; ///< above the outlet level y = 0, in kg
    double mass_falling = 0.; ///< below it, in kg
    double mass_removed = 0.; ///< that left the grid by falling, in kg
    double mass_lost    = 0.; ///< that left the grid otherwise, in kg

    double kinetic_energy    = 0.; ///< in J
    double elastic_energy    = 0.; ///< in J
    double dissipated_energy = 0.; ///< by plastic flow and wall friction, in J

    /// In kg m/s; the horizontal one of the scene.
    Tensor<1, dim> momentum;

    double largest_speed = 0.; ///< in m/s

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
