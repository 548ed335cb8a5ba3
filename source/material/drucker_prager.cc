#include <sandglass/material/drucker_prager.h>

namespace Sandglass
{
  Eigen::Matrix4d
  DruckerPrager::projection_derivative(
    const SymmetricTensor4 &trial_stress) const
  {
    const double p = pressure(trial_stress);
    const double q = von_mises_stress(trial_stress);
    if (p <= 0. && q > 0.)
      return Eigen::Matrix4d::Zero();
    if (q <= yield_slope * p || q == 0.)
      return Eigen::Matrix4d::Identity();

    // stress = (m p / q) s - p 1, differentiated with
    // dp = -1/3 1 : d(trial), dq = 3 / (2 q) s : d(trial)
    const SymmetricTensor4 identity(1., 1., 1., 0.);
    const SymmetricTensor4 s          = deviator(trial_stress);
    const SymmetricTensor4 p_gradient = -identity / 3.;
    SymmetricTensor4       q_gradient = 1.5 / q * s;
    q_gradient[Component::xy] *= 2.;

    const double          ratio = yield_slope * p / q;
    const Eigen::Matrix4d deviatoric =
      Eigen::Matrix4d::Identity() + identity * p_gradient.transpose();
    return ratio * deviatoric +
           s * (yield_slope / q * p_gradient - ratio / q * q_gradient)
                 .transpose() -
           identity * p_gradient.transpose();
  }
} // namespace Sandglass
