#include <deal.II/base/numbers.h>

#include <sandglass/output/eurocode_pressures.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    /// Rounding error of ratios that are exact on paper.
    constexpr double rounding = 1e-9;

    /// EN 1991-4, Section 6.3.2: the empirical coefficient b.
    constexpr double hopper_coefficient = 0.2;
  } // namespace



  EurocodePressures::EurocodePressures(const Silo &silo, const Janssen &janssen)
    : silo(silo)
    , janssen(janssen)
  {}



  bool
  EurocodePressures::is_slender() const
  {
    return silo.width > 0. &&
           silo.wall_height >= 2. * silo.width * (1. - rounding);
  }



  bool
  EurocodePressures::is_intermediate() const
  {
    return silo.width > 0. && !is_slender() &&
           silo.wall_height > silo.width * (1. + rounding);
  }



  bool
  EurocodePressures::is_silo() const
  {
    // Retaining silos are those up to here.
    return silo.width > 0. &&
           silo.wall_height > 0.4 * silo.width * (1. + rounding);
  }



  bool
  EurocodePressures::has_steep_hopper() const
  {
    const double mu =
      silo.hopper_friction_coefficient.value_or(janssen.friction_coefficient);
    return 2. * mu * silo.hopper_slope < 1. - janssen.lateral_pressure_ratio;
  }



  double
  EurocodePressures::hopper_friction() const
  {
    return has_steep_hopper() ?
             silo.hopper_friction_coefficient.value_or(
               janssen.friction_coefficient) :
             (1. - janssen.lateral_pressure_ratio) / (2. * silo.hopper_slope);
  }



  bool
  EurocodePressures::has_central_outlet() const
  {
    return silo.outlet_eccentricity <= 0.25 * silo.width * (1. + rounding);
  }



  WallPressure
  EurocodePressures::on_wall(const Load load, const double depth) const
  {
    if (!is_silo())
      return {};

    double normal = janssen.horizontal_pressure(depth);
    if (!is_slender())
      {
        // Section 5.3.1.1 with h_o = 0 and tan(phi_r) = 0, so n = -1.
        normal = janssen.weight_density * janssen.lateral_pressure_ratio *
                 depth / (1. + relative_depth(depth));
      }
    const double tangential = janssen.friction_coefficient * normal;
    if (load == Load::filling)
      return {normal, tangential};

    if (!has_central_outlet())
      return {};
    const double share = is_slender() ? 1. :
                         is_intermediate() ?
                                        silo.wall_height / silo.width - 1. : // C_S
                           0.;
    return {(1. + 0.15 * share) * normal, (1. + 0.10 * share) * tangential};
  }



  double
  EurocodePressures::patch_factor(const Load load) const
  {
    const double slenderness  = silo.wall_height / silo.width;
    const bool   is_discharge = load == Load::discharge;
    const double eccentricity =
      is_discharge ? 2. * silo.outlet_eccentricity / silo.width : 0.; // E
    if (is_discharge && slenderness <= 1.2)
      return std::max(0.,
                      0.272 * silo.patch_load_factor *
                        (slenderness - 1. + eccentricity));
    return std::max(0.,
                    (is_discharge ? 0.42 : 0.21) * silo.patch_load_factor *
                      (1. + 2. * eccentricity * eccentricity) *
                      -std::expm1(-1.5 * (slenderness - 1.)));
  }



  double
  EurocodePressures::patch(const Load load, const double depth) const
  {
    constexpr double of_band = 0.36;

    const double normal = on_wall(load, depth).normal;
    if (std::isnan(normal))
      return normal;
    return (silo.formulation == Formulation::plane_strain ? of_band : 1.) *
           patch_factor(load) * normal;
  }



  double
  EurocodePressures::relative_depth(const double depth) const
  {
    return janssen.lateral_pressure_ratio * janssen.friction_coefficient *
           depth / janssen.hydraulic_radius;
  }



  double
  EurocodePressures::vertical_pressure(const double depth) const
  {
    if (is_slender())
      return janssen.vertical_pressure(depth);
    // gamma z_V of Section 5.3.1.1 for n = -1: gamma z_o ln(1 + z / z_o).
    const double ratio = relative_depth(depth);
    return janssen.weight_density * depth *
           (ratio > 0. ? std::log1p(ratio) / ratio : 1.);
  }



  double
  EurocodePressures::hopper_ratio(const Load load) const
  {
    const double mu = hopper_friction();
    // Sections 6.3.2 and 6.4, with mu = 0 allowed.
    if (load == Load::filling || !has_steep_hopper())
      return 1. - hopper_coefficient * mu / (mu + silo.hopper_slope);

    // Section 6.3.3; the wall is no rougher than the material.
    const double phi =
      silo.internal_friction_angle * dealii::numbers::PI / 180.;
    if (phi == 0.)
      return 1.;
    const double wall_angle = std::min(std::atan(mu), phi);
    const double epsilon =
      wall_angle + std::asin(std::sin(wall_angle) / std::sin(phi));
    const double beta = std::atan(silo.hopper_slope);
    return (1. + std::sin(phi) * std::cos(epsilon)) /
           (1. - std::sin(phi) * std::cos(2. * beta + epsilon));
  }



  WallPressure
  EurocodePressures::on_hopper(const Load load, const double depth) const
  {
    if (!is_silo() || std::isnan(silo.hopper_slope))
      return {};

    const double mu = hopper_friction();
    const double s  = silo.formulation == Formulation::plane_strain ? 1. : 2.;
    const double ratio = hopper_ratio(load);
    // The exponent that keeps each slice of the hopper in equilibrium. It is
    // the standard's for cones, and on filling for wedges too.
    const double n = s * (ratio * (1. + mu / silo.hopper_slope) - 1.);

    const double hopper_height = silo.width / 2. / silo.hopper_slope; // h_h
    const double x = (hopper_height + silo.wall_height - depth) / hopper_height;
    const double from_weight = std::abs(n - 1.) < rounding ?
                                 -x * std::log(x) :
                                 (x - std::pow(x, n)) / (n - 1.);
    const double vertical =
      janssen.weight_density * hopper_height * from_weight +
      vertical_pressure(silo.wall_height) * std::pow(x, n);
    return {ratio * vertical, mu * ratio * vertical};
  }
} // namespace Sandglass
