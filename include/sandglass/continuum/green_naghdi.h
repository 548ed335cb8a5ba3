#ifndef sandglass_continuum_green_naghdi_h
#define sandglass_continuum_green_naghdi_h

#include <sandglass/continuum/in_plane_rotation.h>

#include <Eigen/Core>

#include <cmath>

namespace Sandglass
{
  /**
   * How one step turns stress if the objective rate is Green and Naghdi's: with
   * the rotation R of the polar decomposition F = R U instead of the spin, so
   * that stress does not oscillate in large shear (dienes1979). A rate needs F,
   * which grows with the whole history of the point.
   */
  struct GreenNaghdiRotation
  {
    InPlaneRotation<double> step; ///< from the start of the step to its end
    InPlaneRotation<double>
      half; ///< half as far: from the step's middle to its end

    /**
     * @param before,after  in-plane deformation gradient F at the start and at
     *                      the end of the step (pure numbers, det F > 0). The
     *                      third direction does not turn.
     */
    GreenNaghdiRotation(const Eigen::Matrix2d &before,
                        const Eigen::Matrix2d &after)
    {
      // R is the rotation by the angle of the vector (F_xx + F_yy, F_yx -
      // F_xy), so its change is the angle between two such vectors.
      const Eigen::Vector2d a      = rotation_vector(before);
      const Eigen::Vector2d b      = rotation_vector(after);
      const double          scale  = 1. / (a.norm() * b.norm());
      const double          cosine = scale * a.dot(b);
      const double          sine   = scale * (a[0] * b[1] - a[1] * b[0]);
      // The pair (d, t) of InPlaneRotation turns twice as far as the plane.
      half = {cosine, sine};
      step = {cosine * cosine - sine * sine, 2. * sine * cosine};
    }

  private:
    static Eigen::Vector2d
    rotation_vector(const Eigen::Matrix2d &gradient)
    {
      return {gradient(0, 0) + gradient(1, 1), gradient(1, 0) - gradient(0, 1)};
    }
  };
} // namespace Sandglass

#endif
