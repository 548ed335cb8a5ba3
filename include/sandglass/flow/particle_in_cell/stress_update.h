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
   * less dense than loosest_density() carries no stress until it is compacted
   * again (after Dunatunga and Kamrin 2015).
   *
   * Where it meets the others lies anywhere within the step, on average in its
   * middle, so only half of that step's strain is resisted. With all of it a
   * particle that collides alone would be thrown back faster than it came, at a
   * frequency omega by the factor (omega dt)^2 - 1.
   */
  template <typename Law>
  class StressUpdate
  {
  public:
    /// @param unstressed_density  in kg/m^3
    StressUpdate(const Law                     &law,
                 const double                   unstressed_density,
                 const ParticleStageParameters &parameters)
      : law(law)
      , loosest_density(law.loosest_density_share() * unstressed_density *
                        (Law::knows_density ? 1. : parameters.loosest_density))
      , smallest_stressed_density(parameters.density_update ==
                                      DensityUpdate::separation ?
                                    loosest_density :
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
      const auto was_separated =
        state.density < Number(smallest_stressed_density);
      state.density *= deformation.inverse_jacobian;
      state.stress = rotate(state.stress, deformation.rotation);
      const Number dissipation =
        law.correct(state.stress, state.law_state, deformation.prediction);

      // Also where nothing separates: to ask first would cost more.
      const Number share =
        select(state.density < Number(smallest_stressed_density),
               Number(0.),
               select(was_separated, Number(resisted_share), Number(1.)));
      for (int c = 0; c < Layout::n_components; ++c)
        state.stress[c] = state.stress[c] * share;
      return share * share * dissipation;
    }

    const Law law;

    /// In kg/m^3; particles without stress that are less dense are separated.
    const double loosest_density;

  private:
    const double smallest_stressed_density; ///< in kg/m^3

    /// Of the strain of the step in which a particle becomes dense.
    static constexpr double resisted_share = 0.5;
  };
} // namespace Sandglass

#endif
