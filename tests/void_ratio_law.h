#ifndef sandglass_tests_void_ratio_law_h
#define sandglass_tests_void_ratio_law_h

#include <sandglass/material/drucker_prager.h>

/**
 * A law with state variables of its own, for tests: the Drucker-Prager cone on
 * an elasticity that grows with pressure, and two variables that it carries
 * along, the void ratio and the sum of the strain increments.
 */
class VoidRatioLaw : public Sandglass::LawDefaults
{
public:
  static constexpr char name[] = "void ratio";

  static constexpr std::array<Sandglass::StateVariable, 2> state_variables = {
    {{"void ratio", "1", 1}, {"summed strain", "1", 4}}};

  static constexpr bool has_constant_stiffness = false;

  static constexpr double initial_void_ratio = 0.8;
  /// Pressure that doubles the stiffness, in Pa.
  static constexpr double doubling_pressure = 2e4;

  explicit VoidRatioLaw(const Sandglass::MaterialConstants &constants)
    : cone(constants)
  {}

  std::array<double, 5>
  initial_state() const
  {
    return {{initial_void_ratio, 0., 0., 0., 0.}};
  }

  double
  loosest_density_share() const
  {
    return 1.;
  }

  /// The strain: stiffness depends on each particle's stress.
  template <typename Increment>
  auto
  predict(const Increment &increment, const double /*time_step*/) const
  {
    return increment.strain;
  }

  template <int n, typename Number, typename State, typename Prediction>
  Number
  correct(Eigen::Matrix<Number, n, 1> &stress,
          State                       &state,
          const Prediction            &prediction) const
  {
    Sandglass::SymmetricComponents<n, Number> strain;
    for (int c = 0; c < n; ++c)
      {
        strain[c] = Number(prediction[c]);
        state[1 + c] += strain[c];
      }
    state[0] += (Number(1.) + state[0]) * Sandglass::trace(strain);

    const Number factor  = stiffening(stress);
    const auto   elastic = cone.elasticity.stress(strain);
    for (int c = 0; c < n; ++c)
      stress[c] += factor * elastic[c];
    return cone.project(stress);
  }

  template <int n, typename State, typename Increment>
  Sandglass::MaterialTangent<n>
  tangent(const Eigen::Matrix<double, n, 1> &stress,
          const State &,
          const Increment &increment,
          const double     elastic_share) const
  {
    // The stiffness is that of the increment's start.
    const double                            factor = stiffening(stress);
    const Sandglass::SymmetricComponents<n> elastic =
      cone.elasticity.stress(increment.strain);
    const Sandglass::SymmetricComponents<n> trial = stress + factor * elastic;
    const auto                              projection =
      cone.stabilized_projection_derivative(trial, elastic_share);
    Sandglass::SymmetricComponents<n> factor_gradient = Sandglass::isotropic<n>(
      Sandglass::pressure(stress) > 0. ? -1. / (3. * doubling_pressure) : 0.);
    return {projection * (Sandglass::ComponentMatrix<n>::Identity() +
                          elastic * factor_gradient.transpose()),
            factor * projection * cone.elasticity.template stiffness<n>()};
  }

  /// Of unstressed material.
  Sandglass::Elasticity
  stiffness_bound() const
  {
    return cone.elasticity;
  }

  template <int n, typename State>
  Sandglass::Elasticity
  stiffness_bound(const Eigen::Matrix<double, n, 1> &stress,
                  const State &) const
  {
    Sandglass::Elasticity bound = cone.elasticity;
    bound.lame_modulus *= stiffening(stress);
    bound.shear_modulus *= stiffening(stress);
    return bound;
  }

  template <int n, typename Number, typename State>
  Number
  energy_density(const Eigen::Matrix<Number, n, 1> &stress, const State &) const
  {
    return cone.elasticity.energy_density(stress) / stiffening(stress);
  }

private:
  /// Factor on the elastic moduli.
  template <int n, typename Number>
  static Number
  stiffening(const Eigen::Matrix<Number, n, 1> &stress)
  {
    using Sandglass::select; // and not that of the system
    const Number p = Sandglass::pressure(stress);
    return Number(1.) + select(p > Number(0.),
                               p * Number(1. / doubling_pressure),
                               Number(0.));
  }

  Sandglass::DruckerPrager cone;
};

#endif
