#ifndef sandglass_tests_manufactured_settlement_h
#define sandglass_tests_manufactured_settlement_h

#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>

#include <sandglass/continuum/formulation.h>
#include <sandglass/material/elasticity.h>

#include <cmath>

#include "divergence.h"

/**
 * Settlement of a unit square, or of a cylinder of radius and height 1,
 * between smooth side walls and on a smooth floor, with a free surface:
 *
 *     u_x =  A b sin(pi x) f(y),               f = (1 - y^2)^2
 *     u_y = -A (g(y) + a cos(pi x) h(y)),      g = y - y^2 / 2,
 *                                              h = y (1 - y)^2
 *
 * Normal displacement and shear stress vanish at the three walls, and all
 * stresses at y = 1, for any elastic constants. It is compressed everywhere,
 * as a material without cohesion must be; a and b make it uneven.
 *
 * The amplitude is so small that what the stage has beside linear elasticity,
 * rotation of the stress and the moved mesh, is far below the error of any
 * mesh: it changes the result by about A.
 */
struct ManufacturedSettlement
{
  static constexpr double pi        = dealii::numbers::PI;
  static constexpr double amplitude = 1e-6, a = 0.2, b = 0.05;

  dealii::Tensor<1, 2>
  displacement(const dealii::Point<2> &point) const
  {
    const double x = point[0], y = point[1];
    return amplitude *
           dealii::Tensor<1, 2>(
             {b * std::sin(pi * x) * std::pow(1. - y * y, 2),
              y * y / 2. - y - a * std::cos(pi * x) * y * std::pow(1. - y, 2)});
  }

  /// Entry (i, j) is the derivative of u_i with respect to x_j.
  dealii::Tensor<2, 2>
  gradient(const dealii::Point<2> &point) const
  {
    const double         x = point[0], y = point[1];
    const double         sine = std::sin(pi * x), cosine = std::cos(pi * x);
    dealii::Tensor<2, 2> result;
    result[0][0] = b * pi * cosine * std::pow(1. - y * y, 2);
    result[0][1] = -4. * b * sine * y * (1. - y * y);
    result[1][0] = a * pi * sine * y * std::pow(1. - y, 2);
    result[1][1] = y - 1. - a * cosine * (1. - y) * (1. - 3. * y);
    return amplitude * result;
  }

  Sandglass::SymmetricComponents<4>
  stress(const dealii::Point<2> &point) const
  {
    const dealii::Tensor<2, 2> H = gradient(point);
    const double hoop = formulation == Sandglass::Formulation::axisymmetric ?
                          displacement(point)[0] / point[0] :
                          0.;
    return elasticity.stress(Sandglass::SymmetricComponents<4>(
      H[0][0], H[1][1], hoop, (H[0][1] + H[1][0]) / 2.));
  }

  /// What holds it in equilibrium, in m/s^2: minus the divergence of the
  /// stress over the density.
  dealii::Tensor<1, 2>
  body_force(const dealii::Point<2> &point) const
  {
    const auto stress_at = [this](const dealii::Point<2> &at) {
      return stress(at);
    };
    return -1. / density * divergence_of(stress_at, point, formulation);
  }

  Sandglass::Formulation formulation;
  Sandglass::Elasticity  elasticity{1e6, 0.3};
  double                 density = 1500.;
};

#endif
