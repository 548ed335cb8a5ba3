#ifndef sandglass_particle_stage_stress_update_h
#define sandglass_particle_stage_stress_update_h

#include <sandglass/material/drucker_prager.h>
#include <sandglass/particle_stage/cell_kernel.h>
#include <sandglass/particle_stage/particle_stage_parameters.h>

namespace Sandglass
{
  /**
   * Step 8 of Section 4.4 for one particle: density, then stress according to
   * Section 4.1.
   *
   * The paper's density, rho / J, falls without bound where material separates
   * again and again, because the stress there returns to zero while the volume
   * keeps growing. The other updates bound it:
   *
   * - constant keeps the density, since plastic flow keeps the volume and
   *   elastic volume changes are small;
   * - floor keeps at least half the material's density;
   * - separation lets it fall, but a particle less dense than the unstressed
   *   material carries no stress until it is compacted again (Dunatunga and
   *   Kamrin 2015).
   */
  template <DensityUpdate density_update>
  class StressUpdate
  {
  public:
    /// @param unstressed_density  in kg/m^3
    StressUpdate(const DruckerPrager &law, const double unstressed_density)
      : law(law)
      , unstressed_density(unstressed_density)
    {}

    /**
     * @param state                particle's properties.
     * @param elastic_increment    elastic stress of the strain increment, Pa.
     * @param[in,out] dissipation  raised by the plastic work, in J.
     */
    void
    operator()(double                 *state,
               const SymmetricTensor4 &elastic_increment,
               const StressRotation   &rotation,
               const double            inverse_jacobian,
               double                 &dissipation) const
    {
      double                      &density = state[Property::density];
      Eigen::Map<SymmetricTensor4> stored_stress(state + Property::stress);

      if constexpr (density_update != DensityUpdate::constant)
        density *= inverse_jacobian;
      if constexpr (density_update == DensityUpdate::floor)
        density = std::max(density, 0.5 * unstressed_density);
      if constexpr (density_update == DensityUpdate::separation)
        if (density < unstressed_density)
          {
            stored_stress.setZero();
            return;
          }

      SymmetricTensor4 stress =
        rotate(stored_stress, rotation) + elastic_increment;
      double dissipation_density = 0.;
      law.project(stress, dissipation_density);
      stored_stress = stress;
      dissipation += dissipation_density * state[Property::mass] / density;
    }

    const DruckerPrager law;

  private:
    const double unstressed_density;
  };
} // namespace Sandglass

#endif
