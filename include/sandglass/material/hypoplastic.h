#ifndef sandglass_material_hypoplastic_h
#define sandglass_material_hypoplastic_h

#include <sandglass/continuum/symmetric_products.h>
#include <sandglass/material/elasticity.h>
#include <sandglass/material/hypoplastic_bound.h>
#include <sandglass/material/hypoplastic_steps.h>
#include <sandglass/material/law_defaults.h>
#include <sandglass/material/numerical_tangent.h>

#include <algorithm>
#include <array>

namespace Sandglass
{
  /**
   * What hypoplastic laws share. Such a law gives the rate of stress as
   * L : D + N ||D||, linear in the stretching D but for its norm, so that
   * loading and unloading differ without a yield surface. L and N depend on
   * stress and void ratio, and stiffness vanishes with stress.
   *
   * So that material without stress can be loaded at all, the law sees all
   * stresses with a small pressure p_t added: without stress there remains the
   * stiffness of p_t. Hypoplastic material has no tension: where the pressure
   * has fallen to zero, the stress is zero, whatever the strain, until
   * pressure grows again.
   *
   * The void ratio follows de = (1 + e) tr D dt also where stress is zero; a
   * law takes it as no further than at its own limits.
   *
   * @tparam Law  the law, which derives from this class and has
   * `stress_rate(stress, void_ratio, strain, norm)` and
   * `stiffness_bound_at(stress, void_ratio)`. Both get stresses with p_t, at
   * least p_t of pressure.
   */
  template <typename Law>
  class Hypoplastic : public LawDefaults
  {
  public:
    static constexpr std::array<StateVariable, 1> state_variables = {
      {{"void ratio", "1", 1}}};

    /// Stiffness grows with stress.
    static constexpr bool has_constant_stiffness = false;

    /// Without an elastic energy; see correct().
    static constexpr bool dissipation_can_fall = true;
    static constexpr bool knows_density        = true;

    static bool
    is_meant(const MaterialConstants &constants)
    {
      return constants.model == Law::name;
    }

    explicit Hypoplastic(const MaterialConstants &constants)
      : small_pressure(law_constant<Law>(constants, "p_t"))
      , initial_void_ratio(constants.void_ratio)
    {}

    /// State variables of unstressed material: the void ratio.
    std::array<double, 1>
    initial_state() const
    {
      return {{initial_void_ratio}};
    }

    /// The strain: all else depends on each particle's stress.
    template <typename Increment>
    auto
    predict(const Increment &increment, const double /*time_step*/) const
    {
      return increment.strain;
    }

    /**
     * Integrate the rate of stress over the increment, with an error of some
     * 1e-4 of the stress (see HypoplasticSteps).
     *
     * @param[in,out] stress  at the start of the step, turned, in Pa; at its
     * end.
     * @return the work of the stress per volume in J/m^3, mean stress : strain.
     *         These laws know no elastic part of the strain, so it can be
     *         negative where the material unloads.
     */
    template <int n, typename Number, typename State, typename Prediction>
    Number
    correct(Eigen::Matrix<Number, n, 1> &stress,
            State                       &state,
            const Prediction            &prediction) const
    {
      SymmetricComponents<n, Number> strain;
      for (int c = 0; c < n; ++c)
        strain[c] = Number(prediction[c]);

      const HypoplasticSteps<Law, n, Number> steps(law(),
                                                   small_pressure,
                                                   strain,
                                                   state[0]);
      const SymmetricComponents<n, Number>   start = steps.shift(stress);
      const SymmetricComponents<n, Number>   end   = steps.integrate(start);
      const Number                           p_t(small_pressure);
      stress   = end + isotropic<n>(p_t);
      state[0] = steps.void_ratio(Number(1.));

      const SymmetricComponents<n, Number> middle =
        Number(0.5) * (start + end) + isotropic<n>(p_t);
      return double_contraction(middle, strain);
    }

    /**
     * Tangent of correct() as Newton's method uses it, by differences.
     *
     * @param stress  at the increment's start, turned, in Pa.
     * @param elastic_share  from 0, the derivative, to 1, the stiffness of
     * stiffness_bound() at the increment's end. Material without stress there
     * has all of it: the derivative is zero, and a node all of whose cells have
     * no stress would have an equation of zeros.
     */
    template <int n, typename State, typename Increment>
    MaterialTangent<n>
    tangent(const Eigen::Matrix<double, n, 1> &stress,
            const State                       &state,
            const Increment                   &increment,
            const double                       elastic_share) const
    {
      constexpr double relative_difference = 1e-3;

      SymmetricComponents<n> end   = stress;
      State                  after = state;
      correct(end, after, increment.strain);

      const Elasticity elastic = stiffness_bound(end, after);
      const double     share   = pressure(end) > 0. ? elastic_share : 1.;

      return with_elastic_share(numerical_tangent(law(),
                                                  stress,
                                                  state,
                                                  increment,
                                                  relative_difference *
                                                    stress_scale(stress)),
                                elastic,
                                share);
    }

    /// An isotropic elasticity that unstressed material is nowhere stiffer
    /// than: that of p_t.
    Elasticity
    stiffness_bound() const
    {
      return stiffness_bound(SymmetricComponents<4>(0., 0., 0., 0.),
                             initial_state());
    }

    /// The same at a stress in Pa: no strain rate finds a stiffer response,
    /// in the sense of D : (rate of stress) <= D : elasticity : D.
    template <int n, typename State>
    Elasticity
    stiffness_bound(const Eigen::Matrix<double, n, 1> &stress,
                    const State                       &state) const
    {
      SymmetricComponents<n> shifted = stress - isotropic<n>(small_pressure);
      if (pressure(stress) <= 0.)
        shifted = isotropic<n>(-small_pressure);
      return law().stiffness_bound_at(shifted, state[0]);
    }

    /// Elastic energy per volume in J/m^3: none, since no part of the strain is
    /// elastic. All work counts as dissipated; see correct().
    template <int n, typename Number, typename State>
    Number
    energy_density(const Eigen::Matrix<Number, n, 1> &, const State &) const
    {
      return Number(0.);
    }

    const double small_pressure;     ///< p_t in Pa
    const double initial_void_ratio; ///< of unstressed material

  protected:
    /// The constant p_t, which each law has.
    static constexpr LawConstant
    small_pressure_constant(const double default_value)
    {
      return {"p_t",
              "Pa",
              default_value,
              1e-3,
              1e5,
              "small pressure whose stiffness material without stress has"};
    }

  private:
    const Law &
    law() const
    {
      return static_cast<const Law &>(*this);
    }

    /// A stress in Pa by which differences at this stress are measured.
    template <int n>
    double
    stress_scale(const Eigen::Matrix<double, n, 1> &stress) const
    {
      return std::max(pressure(stress), 0.) + small_pressure;
    }
  };
} // namespace Sandglass

#endif
