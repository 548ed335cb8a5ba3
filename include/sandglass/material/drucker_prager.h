#ifndef sandglass_material_drucker_prager_h
#define sandglass_material_drucker_prager_h

#include <sandglass/continuum/material_tangent.h>
#include <sandglass/material/elasticity.h>
#include <sandglass/material/material_constants.h>
#include <sandglass/material/state_variable.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  /**
   * Cohesionless Drucker-Prager plasticity, f = q - m p, with the plastic
   * potential g = q, so that plastic flow keeps the volume (paper, Sections 2.2
   * and 4.1). Linear elastic within the yield surface.
   *
   * CONTRIBUTING.md lists what a law has to have.
   */
  class DruckerPrager
  {
  public:
    /// Value of the parameter Material/Model.
    static constexpr char name[] = "Drucker-Prager";
    /// For the documentation of that parameter.
    static constexpr char description[] =
      "cohesionless Drucker-Prager with incompressible plastic flow";

    static constexpr std::array<StateVariable, 0> state_variables = {};

    /// Whether stiffness_bound() is the same for all states.
    static constexpr bool has_constant_stiffness = true;

    /**
     * m = 18 sin(phi) / (9 - sin^2(phi)).
     *
     * @param friction_angle  internal friction angle phi in rad.
     */
    static double
    slope(const double friction_angle)
    {
      const double sine = std::sin(friction_angle);
      return 18. * sine / (9. - sine * sine);
    }

    /// @param friction_angle  internal friction angle phi in rad.
    DruckerPrager(const Elasticity &elasticity, const double friction_angle)
      : elasticity(elasticity)
      , yield_slope(slope(friction_angle))
    {}

    explicit DruckerPrager(const MaterialConstants &constants)
      : DruckerPrager(Elasticity(constants.young_modulus,
                                 constants.poisson_ratio),
                      constants.internal_friction_angle *
                        3.14159265358979323846 / 180.)
    {}

    /// State variables of unstressed material: none.
    std::array<double, 0>
    initial_state() const
    {
      return {};
    }

    /// The elastic change of stress in Pa.
    template <typename Increment>
    auto
    predict(const Increment &increment, const double /*time_step*/) const
    {
      return elasticity.stress(increment.strain);
    }

    /**
     * Add the prediction to a stress, and project the result onto the
     * admissible stresses (three-case formula of Section 4.1).
     *
     * @param[in,out] stress  at the start of the step, turned, in Pa; at its
     * end.
     * @return the plastic work per volume in J/m^3, stress : plastic strain
     *         increment.
     */
    template <int n, typename Number, typename State, typename Prediction>
    Number
    correct(Eigen::Matrix<Number, n, 1> &stress,
            State &,
            const Prediction &prediction) const
    {
      for (int c = 0; c < n; ++c)
        stress[c] += prediction[c];
      return project(stress);
    }

    /**
     * Project a trial stress onto the admissible stresses.
     *
     * @return as correct().
     */
    template <int n, typename Number>
    Number
    project(Eigen::Matrix<Number, n, 1> &stress) const
    {
      using std::sqrt;
      const Number                         p = pressure(stress);
      const SymmetricComponents<n, Number> s = stress + isotropic<n>(p);
      const Number q_squared = Number(1.5) * double_contraction(s, s);
      const Number q_yield   = Number(yield_slope) * p;

      // The comparison makes a stress that is not a number yield, and spread to
      // all components. Otherwise it would stay unseen in a component that no
      // force feels.
      const auto   is_separated = p <= Number(0.);
      const auto   is_elastic   = q_squared <= q_yield * q_yield;
      const Number ratio =
        select(is_elastic, Number(1.), q_yield / sqrt(q_squared));
      for (int c = 0; c < n; ++c)
        {
          const Number normal = c < Component::first_shear ? p : Number(0.);
          stress[c] =
            select(is_separated,
                   Number(0.),
                   select(is_elastic, stress[c], ratio * s[c] - normal));
        }
      // The plastic strain increment is (1 - ratio) s / (2 G).
      return select(is_separated,
                    Number(0.),
                    ratio * (Number(1.) - ratio) * q_squared *
                      Number(1. / (3. * elasticity.shear_modulus)));
    }

    /**
     * Tangent of correct() as Newton's method uses it, also where the
     * projection's derivative is zero or doesn't exist.
     *
     * @param stress  at the increment's start, turned, in Pa.
     * @param elastic_share  from 0, the derivative, to 1, the elastic
     * stiffness.
     */
    template <int n, typename State, typename Increment>
    MaterialTangent<n>
    tangent(const Eigen::Matrix<double, n, 1> &stress,
            const State &,
            const Increment &increment,
            const double     elastic_share) const
    {
      const SymmetricComponents<n> trial_stress =
        stress + predict(increment, 0.);
      const ComponentMatrix<n> projection =
        stabilized_projection_derivative(trial_stress, elastic_share);
      return {projection, projection * elasticity.template stiffness<n>()};
    }

    /// An isotropic elasticity that is nowhere softer than the law.
    Elasticity
    stiffness_bound() const
    {
      return elasticity;
    }

    /// Elastic energy per volume in J/m^3.
    template <int n, typename Number, typename State>
    Number
    energy_density(const Eigen::Matrix<Number, n, 1> &stress,
                   const State &) const
    {
      return elasticity.energy_density(stress);
    }

    /// f = q - m p in Pa; positive outside the yield surface.
    template <int n>
    double
    yield_function(const Eigen::Matrix<double, n, 1> &stress) const
    {
      return von_mises_stress(stress) - yield_slope * pressure(stress);
    }

    /// Derivative of project() with respect to the trial stress.
    template <int n>
    ComponentMatrix<n>
    projection_derivative(const Eigen::Matrix<double, n, 1> &trial_stress) const
    {
      const double p = pressure(trial_stress);
      const double q = von_mises_stress(trial_stress);
      if (p <= 0. && q > 0.)
        return ComponentMatrix<n>::Zero();
      if (q <= yield_slope * p || q == 0.)
        return ComponentMatrix<n>::Identity();

      // stress = (m p / q) s - p 1, differentiated with
      // dp = -1/3 1 : d(trial), dq = 3 / (2 q) s : d(trial)
      const SymmetricComponents<n> identity   = isotropic<n>(1.);
      const SymmetricComponents<n> s          = deviator(trial_stress);
      const SymmetricComponents<n> p_gradient = -identity / 3.;
      SymmetricComponents<n>       q_gradient = 1.5 / q * s;
      for (int c = Component::first_shear; c < n; ++c)
        q_gradient[c] *= 2.;

      const double             ratio = yield_slope * p / q;
      const ComponentMatrix<n> deviatoric =
        ComponentMatrix<n>::Identity() + identity * p_gradient.transpose();
      return ratio * deviatoric +
             s * (yield_slope / q * p_gradient - ratio / q * q_gradient)
                   .transpose() -
             identity * p_gradient.transpose();
    }

    /// As tangent() takes it, see there.
    template <int n>
    ComponentMatrix<n>
    stabilized_projection_derivative(
      const Eigen::Matrix<double, n, 1> &trial_stress,
      const double                       elastic_share) const
    {
      // Share of the elastic stiffness that separated points keep in the
      // tangent (not in the forces). Without it, a node all of whose cells are
      // separated would have an equation of zeros.
      constexpr double separated_stiffness = 1e-3;

      const ComponentMatrix<n> identity = ComponentMatrix<n>::Identity();
      if (trial_stress.isZero(0.))
        {
          // The apex of the cone. Laterally confined compression, elastic with
          // q / p = 2 G / K, leaves it along the yield surface if that is
          // steeper: take its secant, which scales the deviator.
          const double ratio =
            std::min(1.,
                     yield_slope * elasticity.bulk_modulus() /
                       (2. * elasticity.shear_modulus));
          const SymmetricComponents<n> one = isotropic<n>(1.);
          return ratio * identity + (1. - ratio) / 3. * one * one.transpose();
        }
      if (pressure(trial_stress) <= 0.)
        return std::max(separated_stiffness, elastic_share) * identity;
      return (1. - elastic_share) * projection_derivative(trial_stress) +
             elastic_share * identity;
    }

    const Elasticity elasticity;
    const double     yield_slope;
  };
} // namespace Sandglass

#endif
