#ifndef sandglass_continuum_solid_rotation_h
#define sandglass_continuum_solid_rotation_h

#include <sandglass/continuum/symmetric_components.h>

#include <array>
#include <cmath>

namespace Sandglass
{
  /**
   * How one step turns stress in space, by its spin vector w, half the curl of
   * the displacement increment: to first order s becomes s + W s - s W with W x
   * = w x x, as in eq. 1 of the paper; or by the rotation R of W's Cayley
   * transform s becomes R s R^T.
   */
  template <typename Number>
  struct SolidRotation
  {
    std::array<Number, 3> spin; ///< w, in rad
    bool                  is_finite;

    /// Turns like the paper's forward-Euler rule: the stress grows a little.
    static SolidRotation
    forward_euler(const std::array<Number, 3> &spin)
    {
      return {spin, false};
    }

    /**
     * Turns about the spin by the angle theta of tan(theta / 2) = |w| / 2
     * (Hughes and Winget 1980), which is exact if the spin is that of the
     * increment's middle.
     */
    static SolidRotation
    hughes_winget(const std::array<Number, 3> &spin)
    {
      return {spin, true};
    }

    /// Half of hughes_winget(): from the middle of the step to its end.
    static SolidRotation
    half_hughes_winget(const std::array<Number, 3> &spin)
    {
      using std::sqrt;
      const Number scale =
        Number(1.) /
        (Number(1.) + sqrt(Number(1.) + Number(0.25) * squared_norm(spin)));
      return {{{scale * spin[0], scale * spin[1], scale * spin[2]}}, true};
    }

    /// R of the Cayley transform, row by row.
    std::array<Number, 9>
    matrix() const
    {
      const Number half(0.5), one(1.);
      const Number k      = one / (one + Number(0.25) * squared_norm(spin));
      const Number cosine = one - half * k * squared_norm(spin);
      const Number x = k * spin[0], y = k * spin[1], z = k * spin[2];
      const Number xy = half * x * spin[1], yz = half * y * spin[2],
                   xz = half * x * spin[2];
      return {{cosine + half * x * spin[0],
               xy - z,
               xz + y,
               xy + z,
               cosine + half * y * spin[1],
               yz - x,
               xz - y,
               yz + x,
               cosine + half * z * spin[2]}};
    }

    static Number
    squared_norm(const std::array<Number, 3> &vector)
    {
      return vector[0] * vector[0] + vector[1] * vector[1] +
             vector[2] * vector[2];
    }
  };

  /// The change of stress by a small rotation: W s - s W (paper, eq. 1).
  ///
  /// @param spin  half the curl of the displacement increment, in rad.
  template <typename Number, typename Spin>
  SymmetricComponents<6, Number>
  jaumann_rotation(const Eigen::Matrix<Number, 6, 1> &stress,
                   const std::array<Spin, 3>         &spin)
  {
    const Number &xx = stress[0], &yy = stress[1], &zz = stress[2],
                 &xy = stress[3], &yz = stress[4], &xz = stress[5];
    const Spin  &wx = spin[0], &wy = spin[1], &wz = spin[2];
    const Number about_x = wx * yz, about_y = wy * xz, about_z = wz * xy;

    SymmetricComponents<6, Number> change;
    change[0] = Number(2.) * (about_y - about_z);
    change[1] = Number(2.) * (about_z - about_x);
    change[2] = Number(2.) * (about_x - about_y);
    change[3] = wz * (xx - yy) + wy * yz - wx * xz;
    change[4] = wx * (yy - zz) + wz * xz - wy * xy;
    change[5] = wy * (zz - xx) + wx * xy - wz * yz;
    return change;
  }

  /// @tparam Spin  the stress's number type, or double for a rotation that all
  ///               lanes share.
  template <typename Number, typename Spin>
  SymmetricComponents<6, Number>
  rotate(const Eigen::Matrix<Number, 6, 1> &stress,
         const SolidRotation<Spin>         &rotation)
  {
    if (!rotation.is_finite)
      return stress + jaumann_rotation(stress, rotation.spin);

    constexpr int component[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    const auto    R               = rotation.matrix();
    Number        half_turned[3][3]; // R s
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        half_turned[i][j] = R[3 * i] * stress[component[0][j]] +
                            R[3 * i + 1] * stress[component[1][j]] +
                            R[3 * i + 2] * stress[component[2][j]];
    SymmetricComponents<6, Number> result;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        result[component[i][j]] = half_turned[i][0] * R[3 * j] +
                                  half_turned[i][1] * R[3 * j + 1] +
                                  half_turned[i][2] * R[3 * j + 2];
    return result;
  }

  /// For laws that have to know the rotation, see rotation_increment.h: that of
  /// the spin's Cayley transform, also of a step to first order.
  template <typename Number>
  std::array<Number, 9>
  rotation_numbers(const SolidRotation<Number> &rotation)
  {
    return rotation.matrix();
  }
} // namespace Sandglass

#endif
