#ifndef sandglass_flow_particle_in_cell_law_interface_h
#define sandglass_flow_particle_in_cell_law_interface_h

#include <sandglass/flow/clock.h>
#include <sandglass/flow/particle_in_cell/nodal_sums.h>
#include <sandglass/flow/particle_in_cell/particle_stage_parameters.h>
#include <sandglass/flow/particle_in_cell/volumetric_average.h>
#include <sandglass/material/elasticity.h>
#include <sandglass/material/material_constants.h>
#include <sandglass/material/state_variable.h>
#include <sandglass/particles/strays.h>

#include <memory>
#include <vector>

namespace Sandglass
{
  /**
   * What the particle stage asks its constitutive law. One call passes over all
   * particles, so that only this pass is compiled anew for each law.
   */
  template <typename Setting>
  class LawInterface
  {
  public:
    static constexpr int dim = Setting::dim;

    using Layout = typename Setting::Layout;
    using Blocks = ParticleBlocks<Layout>;

    LawInterface(const bool has_constant_stiffness,
                 const bool dissipation_can_fall,
                 const bool takes_averaged_strain)
      : has_constant_stiffness(has_constant_stiffness)
      , dissipation_can_fall(dissipation_can_fall)
      , takes_averaged_strain(takes_averaged_strain)
    {}

    virtual ~LawInterface() = default;

    /**
     * Steps 6, 8 and 9 of Section 4.4, and the next step's sums; see
     * ParticlePass.
     *
     * @param pic_share  see approach().
     * @return the plastic work of the step in J.
     */
    virtual double
    pass(Blocks                     &blocks,
         const NodalField<dim>      &acceleration,
         const NodalField<dim>      &velocity,
         const Clock                &clock,
         const double                pic_share,
         NodalSums<Setting>         &sums,
         VolumetricAverage<Setting> &volumetric_average,
         Strays<Layout>             &strays) const = 0;

    /// An isotropic elasticity than which unstressed material is nowhere
    /// stiffer.
    virtual Elasticity
    stiffness_bound() const = 0;

    /// The same for the state of one particle.
    virtual Elasticity
    stiffness_bound(const ParticleState<Layout, double> &state) const = 0;

    /// Of four particles, in J/m^3. By reference, since instruction sets don't
    /// agree on how four numbers are returned.
    virtual void
    energy_density(const ParticleState<Layout, Lanes> &state,
                   Lanes                              &result) const = 0;

    virtual std::vector<StateVariable>
    state_variables() const = 0;

    /// State variables of unstressed material.
    virtual std::vector<double>
    initial_state() const = 0;

    /// In kg/m^3; particles without stress that are less dense are separated.
    virtual double
    loosest_density() const = 0;

    /// Whether stiffness_bound() is the same for all states.
    const bool has_constant_stiffness;

    /// Whether the law can't tell elastic energy from what is dissipated.
    const bool dissipation_can_fall;

    /// Whether particles may take the volumetric strain of their cells'
    /// neighbourhood.
    const bool takes_averaged_strain;
  };

  /**
   * A law as the particle stage sees it. Defined in law_adapter.h and
   * instantiated by cmake/choices.cmake.
   *
   * @param geometry  has to live as long as the result.
   */
  template <typename Setting, typename Law>
  std::unique_ptr<const LawInterface<Setting>>
  make_law(const MaterialConstants                &constants,
           const ParticleStageParameters          &parameters,
           const CellGeometry<Setting::cell_type> &geometry);
} // namespace Sandglass

#endif
