#ifndef sandglass_flow_particle_in_cell_stress_update_h
#define sandglass_flow_particle_in_cell_stress_update_h

#include <sandglass/flow/particle_in_cell/particle_stage_parameters.h>
#include <sandglass/particles/particle_state.h>

namespace Sandglass
{
  /// What a step does to a particle's stress and density.
  template <typename Prediction, typename Rotation, typename Number>
  struct ParticleDeformation
  {
    Prediction prediction; ///< of the law
    Rotation   rotation;
    Number     inverse_jacobian;
  };

  /**
   * Step 8 of Section 4.4 for one particle or a block of them: density, then
   * stress according to Section 4.1.
   *
   * The paper's density, rho / J, falls without bound where material separates
   * again and again, because the stress there returns to zero while the volume
   * keeps growing. With DensityUpdate::separation it may fall, but a particle
   * less dense than the unstressed material carries no stress until it is
   * compacted again (Dunatunga and Kamrin 2015).
   */
  template <typename Law>
  class StressUpdate
  {
  public:
    /// @param unstressed_density  in kg/m^3
    StressUpdate(const Law          &law,
                 const double        unstressed_density,
                 const DensityUpdate density_update)
      : law(law)
      , smallest_stressed_density(density_update == DensityUpdate::separation ?
                                    law.loosest_density_share() *
                                      unstressed_density :
                                    0.)
    {}

    /**
     * @tparam Deformation  ParticleDeformation of the state's number type, or
     * of double where all lanes have the same.
     * @return the plastic work of the step per volume, in J/m^3.
     */
    template <typename Layout, typename Number, typename Deformation>
    Number
    operator()(ParticleState<Layout, Number> &state,
               const Deformation             &deformation) const
    {
      state.density *= deformation.inverse_jacobian;
      state.stress = rotate(state.stress, deformation.rotation);
      const Number dissipation =
        law.correct(state.stress, state.law_state, deformation.prediction);

      // Also where nothing separates: to ask first would cost more.
      const auto is_separated =
        state.density < Number(smallest_stressed_density);
      for (int c = 0; c < Layout::n_components; ++c)
        state.stress[c] = select(is_separated, Number(0.), state.stress[c]);
      return select(is_separated, Number(0.), dissipation);
    }

    const Law    law;
    const double smallest_stressed_density; ///< in kg/m^3
  };
} // namespace Sandglass

#endif
