#ifndef sandglass_particle_stage_stress_update_h
#define sandglass_particle_stage_stress_update_h

#include <sandglass/material/drucker_prager.h>
#include <sandglass/particle_stage/particle_stage_parameters.h>
#include <sandglass/particles/particle_state.h>

namespace Sandglass
{
  /// What a step does to a particle's stress and density.
  template <typename Number>
  struct ParticleDeformation
  {
    SymmetricTensorOf<Number> elastic_stress; ///< of the strain, in Pa
    StressRotation<Number>    rotation;
    Number                    inverse_jacobian;
  };

  /**
   * Step 8 of Section 4.4 for one particle or a block of them: density, then
   * stress according to Section 4.1.
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
     * @tparam Deformation  ParticleDeformation of Number, or of double where
     *                      all lanes have the same.
     * @return the plastic work of the step per volume, in J/m^3.
     */
    template <typename Number, typename Deformation>
    Number
    operator()(ParticleState<Number> &state,
               const Deformation     &deformation) const
    {
      if constexpr (density_update != DensityUpdate::constant)
        state.density *= deformation.inverse_jacobian;
      if constexpr (density_update == DensityUpdate::floor)
        state.density = select(state.density > Number(0.5 * unstressed_density),
                               state.density,
                               Number(0.5 * unstressed_density));

      state.stress = rotate(state.stress, deformation.rotation);
      for (unsigned int c = 0; c < 4; ++c)
        state.stress[c] += deformation.elastic_stress[c];
      Number dissipation = law.project(state.stress);

      if constexpr (density_update == DensityUpdate::separation)
        {
          const auto is_separated = state.density < Number(unstressed_density);
          for (unsigned int c = 0; c < 4; ++c)
            state.stress[c] = select(is_separated, Number(0.), state.stress[c]);
          dissipation = select(is_separated, Number(0.), dissipation);
        }
      return dissipation;
    }

    const DruckerPrager law;

  private:
    const double unstressed_density;
  };
} // namespace Sandglass

#endif
