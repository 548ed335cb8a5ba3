#ifndef sandglass_flow_particle_in_cell_law_adapter_h
#define sandglass_flow_particle_in_cell_law_adapter_h

#include <sandglass/flow/particle_in_cell/law_interface.h>
#include <sandglass/flow/particle_in_cell/particle_pass.h>

namespace Sandglass
{
  /// A law as the particle stage sees it.
  template <typename Setting, typename Law>
  class LawAdapter final : public LawInterface<Setting>
  {
  public:
    using Base     = LawInterface<Setting>;
    using Layout   = typename Setting::Layout;
    using Geometry = CellGeometry<Setting::cell_type>;

    static constexpr int dim = Setting::dim;

    /// `geometry` has to live as long as this object.
    LawAdapter(const MaterialConstants       &constants,
               const ParticleStageParameters &parameters,
               const Geometry                &geometry)
      : Base(Law::has_constant_stiffness,
             Law::dissipation_can_fall,
             Law::takes_averaged_strain)
      , stress_update(Law(constants), constants.density, parameters)
      , integration(parameters.stress_integration)
      , geometry(geometry)
    {}

    double
    pass(typename Base::Blocks      &blocks,
         const NodalField<dim>      &acceleration,
         const NodalField<dim>      &velocity,
         const Clock                &clock,
         const double                pic_share,
         NodalSums<Setting>         &sums,
         VolumetricAverage<Setting> &volumetric_average,
         Strays<Layout>             &strays) const override
    {
      const auto run = [&](const auto pass) {
        return pass.run(
          blocks, acceleration, velocity, sums, volumetric_average, strays);
      };
      if constexpr (Law::takes_averaged_strain)
        if (volumetric_average.is_on)
          return run(pass_of<true>(pic_share, clock.time_step));
      return run(pass_of<false>(pic_share, clock.time_step));
    }

    Elasticity
    stiffness_bound() const override
    {
      return law().stiffness_bound();
    }

    Elasticity
    stiffness_bound(const ParticleState<Layout, double> &state) const override
    {
      if constexpr (Law::has_constant_stiffness)
        return law().stiffness_bound();
      else
        return law().stiffness_bound(state.stress, state.law_state);
    }

    void
    energy_density(const ParticleState<Layout, Lanes> &state,
                   Lanes                              &result) const override
    {
      result = law().energy_density(state.stress, state.law_state);
    }

    std::vector<StateVariable>
    state_variables() const override
    {
      return {Law::state_variables.begin(), Law::state_variables.end()};
    }

    std::vector<double>
    initial_state() const override
    {
      const auto state = law().initial_state();
      return {state.begin(), state.end()};
    }

    double
    loosest_density() const override
    {
      return stress_update.loosest_density;
    }

  private:
    const Law &
    law() const
    {
      return stress_update.law;
    }

    template <bool is_averaged>
    ParticlePass<Setting, Law, is_averaged>
    pass_of(const double pic_share, const double time_step) const
    {
      return {geometry, stress_update, integration, pic_share, time_step};
    }

    const StressUpdate<Law> stress_update;
    const StressIntegration integration;
    const Geometry         &geometry;
  };



  template <typename Setting, typename Law>
  std::unique_ptr<const LawInterface<Setting>>
  make_law(const MaterialConstants                &constants,
           const ParticleStageParameters          &parameters,
           const CellGeometry<Setting::cell_type> &geometry)
  {
    return std::make_unique<const LawAdapter<Setting, Law>>(constants,
                                                            parameters,
                                                            geometry);
  }
} // namespace Sandglass

#endif
