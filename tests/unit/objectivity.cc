#include <deal.II/base/tensor.h>

#include <sandglass/continuum/in_plane_increment.h>
#include <sandglass/material/elasticity.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

using namespace dealii;
using namespace Sandglass;

namespace
{
  const Elasticity elasticity(1e6, 0.3);

  /// Stress after a step, without yielding, as in the particle stage.
  SymmetricComponents<4>
  after_step(const SymmetricComponents<4> &stress,
             const Tensor<2, 2>           &gradient,
             const StressIntegration       integration)
  {
    const InPlaneIncrement<double> increment(gradient, 0., integration);
    return rotate(stress, increment.rotation) +
           elasticity.stress(increment.strain);
  }

  /// Relative change of q after ten rigid turns in n_steps.
  double
  drift_of_rigid_turns(const unsigned int      n_steps,
                       const StressIntegration integration)
  {
    const double angle = 20. * dealii::numbers::PI / n_steps;
    Tensor<2, 2> gradient; // R - 1
    gradient[0][0] = gradient[1][1] = std::cos(angle) - 1.;
    gradient[1][0]                  = std::sin(angle);
    gradient[0][1]                  = -gradient[1][0];

    const SymmetricComponents<4> start(-3e3, -5e3, -2e3, 7e2);
    SymmetricComponents<4>       stress = start;
    for (unsigned int step = 0; step < n_steps; ++step)
      stress = after_step(stress, gradient, integration);
    return (stress - start).norm() / start.norm();
  }

  /// Largest error of the shear stress in simple shear up to gamma = 20, over
  /// G; Jaumann's rate gives G sin(gamma).
  double
  error_of_simple_shear(const unsigned int      n_steps,
                        const StressIntegration integration)
  {
    Tensor<2, 2> gradient;
    gradient[0][1]                = 20. / n_steps;
    const double           G      = elasticity.shear_modulus;
    SymmetricComponents<4> stress = SymmetricComponents<4>::Zero();
    double                 error  = 0.;
    for (unsigned int step = 1; step <= n_steps; ++step)
      {
        stress = after_step(stress, gradient, integration);
        error  = std::max(error,
                         std::abs(stress[Component::xy] / G -
                                  std::sin(step * gradient[0][1])));
      }
    return error;
  }
} // namespace



TEST(Objectivity, TheMiddleOfTheStepKeepsStressInRigidTurns)
{
  for (const unsigned int n_steps : {100u, 1000u, 10000u})
    {
      const double middle =
        drift_of_rigid_turns(n_steps, StressIntegration::middle_of_step);
      const double start =
        drift_of_rigid_turns(n_steps, StressIntegration::start_of_step);
      std::cout << "drift of stress after ten turns in " << n_steps
                << " steps: middle " << middle << ", start " << start
                << std::endl;
      EXPECT_LT(middle, 1e-10);
      EXPECT_GT(start, 1e-3);
    }
}



TEST(Objectivity, SimpleShearFollowsTheSineOfJaumannsRate)
{
  const auto errors = [](const StressIntegration integration) {
    const std::array<double, 3> result{
      {error_of_simple_shear(1000, integration),
       error_of_simple_shear(4000, integration),
       error_of_simple_shear(16000, integration)}};
    std::cout << "errors of sigma_xy / G in 1000, 4000, 16000 steps "
              << result[0] << ' ' << result[1] << ' ' << result[2] << std::endl;
    return result;
  };
  const auto start  = errors(StressIntegration::start_of_step);
  const auto middle = errors(StressIntegration::middle_of_step);
  EXPECT_NEAR(std::log(start[1] / start[2]) / std::log(4.), 1., 0.1);
  EXPECT_NEAR(std::log(middle[1] / middle[2]) / std::log(4.), 2., 0.1);
  EXPECT_LT(middle[2], 1e-3);
}
