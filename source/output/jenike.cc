#include <deal.II/base/numbers.h>

#include <sandglass/output/jenike.h>

#include <boost/math/tools/roots.hpp>
#include <boost/numeric/odeint.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace Sandglass
{
  namespace
  {
    constexpr double pi   = dealii::numbers::PI;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();

    /// Mean stress s over gamma r, and the angle psi between the radius and the
    /// direction of the largest stress.
    using State = std::array<double, 2>;

    /// Equilibrium of the radial stress field in a wedge (n = 0) or a cone (n =
    /// 1), whose hoop stress is the largest principal stress.
    struct RadialEquilibrium
    {
      double sine; ///< of the friction angle
      double n;

      void
      operator()(const State &state, State &rate, const double angle) const
      {
        const double s = state[0], S = sine, kappa = 1. + S;
        const double c2 = std::cos(2. * state[1]), s2 = std::sin(2. * state[1]);
        const double cot = 1. / std::tan(angle);

        const double a11 = S * s2, a12 = 2. * s * S * c2;
        const double a21 = 1. - S * c2, a22 = 2. * s * S * s2;
        const double b1 =
          -(s * (1. + S * c2) +
            s * (2. * S * c2 + n * (1. + S * c2 - kappa) + n * S * s2 * cot) +
            std::cos(angle));
        const double b2 =
          -(s * S * s2 +
            s * (2. * S * s2 + n * ((1. - S * c2 - kappa) * cot + S * s2)) -
            std::sin(angle));
        const double determinant = a11 * a22 - a12 * a21;
        rate                     = {{(b1 * a22 - b2 * a12) / determinant,
                                     (a11 * b2 - a21 * b1) / determinant}};
      }

      /// d psi / d theta on the axis.
      double
      turning(const double s) const
      {
        return n > 0. ? (s * (1. - 5. * sine) + 1.) / (4. * s * sine) :
                        (s * (1. - 3. * sine) + 1.) / (2. * s * sine);
      }

      /// The state at the wall if the mean stress on the axis is s.
      State
      at_wall(const double s, const double wall) const
      {
        constexpr double       first   = 1e-5; // the axis itself is singular
        constexpr unsigned int n_steps = 500;
        namespace odeint               = boost::numeric::odeint;
        State state{{s, 0.5 * pi + turning(s) * first}};
        odeint::integrate_n_steps(odeint::runge_kutta4<State>(),
                                  *this,
                                  state,
                                  first,
                                  (wall - first) / n_steps,
                                  n_steps);
        return state;
      }
    };
  } // namespace



  Jenike::RadialStress
  Jenike::radial_stress() const
  {
    const double sine      = std::sin(friction_angle);
    const double wall_sine = std::sin(wall_friction_angle);
    if (!(hopper_angle > 0.) || !(sine > 0.) || wall_sine > sine)
      return {none, none};
    const RadialEquilibrium equilibrium{
      sine, formulation == Formulation::axisymmetric ? 1. : 0.};
    const double wall_psi =
      0.5 * (pi + wall_friction_angle + std::asin(wall_sine / sine));
    const auto excess = [&](const double log_s) {
      const double psi =
        equilibrium.at_wall(std::exp(log_s), hopper_angle)[1] - wall_psi;
      return std::isfinite(psi) ? psi : 10.;
    };

    // From large stresses on the axis to small ones, psi at the wall rises.
    constexpr double step  = 0.02;
    double           log_s = std::log(20.);
    if (excess(log_s) > 0.)
      return {none, none};
    while (excess(log_s - step) < 0.)
      {
        log_s -= step;
        if (log_s < -8.)
          return {none, none};
      }
    std::uintmax_t n_iterations = 100;
    const auto     bracket      = boost::math::tools::toms748_solve(
      excess,
      log_s - step,
      log_s,
      boost::math::tools::eps_tolerance<double>(40),
      n_iterations);
    const State state =
      equilibrium.at_wall(std::exp(bracket.second), hopper_angle);
    return {state[0], state[0] * (1. - sine * std::cos(2. * state[1]))};
  }



  double
  Jenike::flow_factor() const
  {
    return radial_stress().mean * (1. + std::sin(friction_angle)) *
           arch_factor() / (2. * std::sin(hopper_angle));
  }



  double
  Jenike::mass_flow_limit() const
  {
    const double sine = std::sin(friction_angle);
    const double wall = std::asin(std::sin(wall_friction_angle) / sine);
    return 0.5 * pi - 0.5 * std::acos((1. - sine) / (2. * sine)) -
           0.5 * (wall_friction_angle + wall);
  }



  double
  Jenike::arch_factor() const
  {
    const double degrees = hopper_angle * 180. / pi;
    return formulation == Formulation::axisymmetric ? 2. + degrees / 60. :
                                                      1. + degrees / 180.;
  }



  double
  Jenike::arching_width(const double strength,
                        const double weight_density) const
  {
    return arch_factor() * strength / weight_density;
  }



  double
  Jenike::rathole_diameter(const double strength,
                           const double weight_density) const
  {
    return 4.3 * std::tan(friction_angle) * strength / weight_density;
  }
} // namespace Sandglass
