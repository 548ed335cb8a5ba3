#ifndef sandglass_continuum_in_plane_rotation_h
#define sandglass_continuum_in_plane_rotation_h

#include <sandglass/continuum/symmetric_components.h>

namespace Sandglass
{
  /**
   * How one step turns stress in the plane: the deviatoric pair (d, t) = ((s_xx
   * - s_yy) / 2, s_xy) becomes (cosine d - sine t, sine d + cosine t).
   */
  template <typename Number>
  struct InPlaneRotation
  {
    Number cosine;
    Number sine;

    /// Turns like jaumann_rotation(): first order, the stress grows a little.
    static InPlaneRotation
    forward_euler(const Number &spin)
    {
      return {Number(1.), Number(2.) * spin};
    }

    /**
     * Turns by the angle theta of tan(theta / 2) = spin / 2 (Hughes and Winget
     * 1980), which is exact if `spin` is that of the increment's middle.
     */
    static InPlaneRotation
    hughes_winget(const Number &spin)
    {
      const InPlaneRotation half = half_hughes_winget(spin);
      return {half.cosine * half.cosine - half.sine * half.sine,
              Number(2.) * half.sine * half.cosine};
    }

    /// Half of hughes_winget(): from the middle of the step to its end.
    static InPlaneRotation
    half_hughes_winget(const Number &spin)
    {
      const Number t       = Number(0.5) * spin;
      const Number inverse = Number(1.) / (Number(1.) + t * t);
      return {(Number(1.) - t * t) * inverse, Number(2.) * t * inverse};
    }
  };

  /// @tparam Rotation  InPlaneRotation of the stress's number type, or of
  /// double
  ///                   for a rotation that all lanes share.
  template <typename Number, typename Rotation>
  SymmetricComponents<4, Number>
  rotate(const Eigen::Matrix<Number, 4, 1> &stress, const Rotation &rotation)
  {
    const Number half(0.5);
    const Number mean  = half * (stress[Component::xx] + stress[Component::yy]);
    const Number d     = half * (stress[Component::xx] - stress[Component::yy]);
    const Number t     = stress[Component::xy];
    const Number new_d = rotation.cosine * d - rotation.sine * t;
    const Number new_t = rotation.sine * d + rotation.cosine * t;
    return {mean + new_d, mean - new_d, stress[Component::zz], new_t};
  }

  /**
   * The change of stress by a small rotation, in forward-Euler form (paper,
   * eq. 1 and Section 4.1): stress_ik spin_kj + stress_jk spin_ki.
   *
   * @param spin  omega_xy = (dv/dx - du/dy) / 2 of the displacement increment,
   *              positive counterclockwise, in rad.
   */
  inline SymmetricComponents<4>
  jaumann_rotation(const SymmetricComponents<4> &stress, const double spin)
  {
    const double shear = 2. * stress[Component::xy] * spin;
    return {-shear,
            shear,
            0.,
            (stress[Component::xx] - stress[Component::yy]) * spin};
  }
} // namespace Sandglass

#endif
