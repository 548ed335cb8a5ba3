#ifndef sandglass_tests_associated_drucker_prager_h
#define sandglass_tests_associated_drucker_prager_h

#include <sandglass/material/drucker_prager.h>

#include <cmath>

/**
 * Drucker and Prager's cone with associated flow, for tests of limit loads,
 * whose closed forms are for it. The law of the program keeps the volume in
 * plastic flow.
 */
class AssociatedDruckerPrager
  : public Sandglass::IsochoricPlasticity<Sandglass::CircularCone>
{
public:
  /// The cone on which a friction angle and a cohesion act in plane flow, with
  /// associated flow.
  explicit AssociatedDruckerPrager(
    const Sandglass::MaterialConstants &constants)
    : IsochoricPlasticity(Sandglass::Elasticity(constants.young_modulus,
                                                constants.poisson_ratio),
                          {factor(constants) * tangent_of_angle(constants),
                           factor(constants) * constants.cohesion},
                          constants.cohesion / tangent_of_angle(constants))
  {}

  template <int n, typename State, typename Prediction>
  double
  correct(Eigen::Matrix<double, n, 1> &stress,
          State &,
          const Prediction &prediction) const
  {
    stress += prediction;
    project(stress);
    return 0.; // no test asks for the plastic work
  }

  template <int n, typename State, typename Increment>
  Sandglass::MaterialTangent<n>
  tangent(const Eigen::Matrix<double, n, 1> &stress,
          const State &,
          const Increment &increment,
          const double     elastic_share) const
  {
    const Eigen::Matrix<double, n, 1> trial = stress + predict(increment, 0.);
    const double step = 1e-6 * (cone.strength + trial.cwiseAbs().maxCoeff());
    Sandglass::ComponentMatrix<n> projection;
    for (int c = 0; c < n; ++c)
      {
        Eigen::Matrix<double, n, 1> more = trial, less = trial;
        more[c] += step;
        less[c] -= step;
        project(more);
        project(less);
        projection.col(c) = (1. - elastic_share) * (more - less) / (2. * step);
        projection(c, c) += elastic_share;
      }
    return {projection, projection * elasticity.template stiffness<n>()};
  }

private:
  static double
  tangent_of_angle(const Sandglass::MaterialConstants &constants)
  {
    return std::tan(Sandglass::friction_angle(constants));
  }

  static double
  factor(const Sandglass::MaterialConstants &constants)
  {
    return std::sqrt(27.) /
           std::sqrt(9. + 12. * std::pow(tangent_of_angle(constants), 2));
  }

  /// The closest point, in the measure of the elastic energy, of the cone.
  template <int n>
  void
  project(Eigen::Matrix<double, n, 1> &stress) const
  {
    const double p      = Sandglass::pressure(stress);
    const double q      = Sandglass::von_mises_stress(stress);
    const double excess = q - cone.slope * p - cone.strength;
    if (excess <= 0.)
      return;
    const double K = elasticity.bulk_modulus(), G = elasticity.shear_modulus;
    const double multiplier = excess / (3. * G + K * cone.slope * cone.slope);
    const double new_q      = q - 3. * G * multiplier;
    // Beyond the apex there is nothing but it.
    const double new_p = new_q > 0. ? p + K * cone.slope * multiplier :
                                      -cone.strength / cone.slope;
    stress             = std::max(new_q, 0.) / q * Sandglass::deviator(stress) -
             Sandglass::isotropic<n>(new_p);
  }
};

#endif
