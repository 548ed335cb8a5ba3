#ifndef sandglass_material_stress_h
#define sandglass_material_stress_h

#include <sandglass/base/lanes.h>

#include <Eigen/Core>

namespace Sandglass
{
  /**
   * The four components of a symmetric tensor that plane strain and axisymmetry
   * leave: (xx, yy, zz, xy), where zz is the out-of-plane or hoop component.
   * Stresses are in Pa, tension positive. The shear component is the tensor's,
   * not the engineering strain.
   *
   * `Number` is double for one tensor, Lanes for those of several particles.
   */
  template <typename Number>
  using SymmetricTensorOf = Eigen::Matrix<Number, 4, 1>;

  using SymmetricTensor4 = SymmetricTensorOf<double>;

  namespace Component
  {
    enum : int
    {
      xx = 0,
      yy = 1,
      zz = 2,
      xy = 3
    };
  }

  /// p = -tr(stress) / 3, compression positive (paper, Section 2.2).
  template <typename Derived>
  typename Derived::Scalar
  pressure(const Eigen::MatrixBase<Derived> &stress)
  {
    using Number = typename Derived::Scalar;
    return -(stress[Component::xx] + stress[Component::yy] +
             stress[Component::zz]) *
           Number(1. / 3.);
  }

  /// The isotropic tensor with `value` on its diagonal.
  template <typename Number>
  SymmetricTensorOf<Number>
  isotropic(const Number &value)
  {
    return {value, value, value, Number(0.)};
  }

  template <typename Derived>
  SymmetricTensorOf<typename Derived::Scalar>
  deviator(const Eigen::MatrixBase<Derived> &stress)
  {
    return stress + isotropic(pressure(stress));
  }

  /// a : b; the shear component counts twice.
  template <typename Number>
  Number
  double_contraction(const SymmetricTensorOf<Number> &a,
                     const SymmetricTensorOf<Number> &b)
  {
    return a.dot(b) + a[Component::xy] * b[Component::xy];
  }

  /// q^2 = 3/2 s : s of the deviator s.
  inline double
  squared_von_mises_stress(const SymmetricTensor4 &stress)
  {
    const SymmetricTensor4 s = deviator(stress);
    return 1.5 * double_contraction(s, s);
  }

  /// q = sqrt(3/2 s : s) (paper, Section 2.2).
  inline double
  von_mises_stress(const SymmetricTensor4 &stress)
  {
    return std::sqrt(squared_von_mises_stress(stress));
  }

  /**
   * The change of stress by a small rotation, in forward-Euler form (paper,
   * eq. 1 and Section 4.1): stress_ik spin_kj + stress_jk spin_ki.
   *
   * @param spin  omega_xy = (dv/dx - du/dy) / 2 of the displacement increment,
   *              positive counterclockwise, in rad.
   */
  inline SymmetricTensor4
  jaumann_rotation(const SymmetricTensor4 &stress, const double spin)
  {
    const double shear = 2. * stress[Component::xy] * spin;
    return {-shear,
            shear,
            0.,
            (stress[Component::xx] - stress[Component::yy]) * spin};
  }



  /**
   * How one step turns stress in the plane: the deviatoric pair (d, t) = ((s_xx
   * - s_yy) / 2, s_xy) becomes (cosine d - sine t, sine d + cosine t).
   */
  template <typename Number>
  struct StressRotation
  {
    Number cosine;
    Number sine;

    /// As jaumann_rotation(): first order, the stress grows a little.
    static StressRotation
    forward_euler(const Number &spin)
    {
      return {Number(1.), Number(2.) * spin};
    }

    /**
     * By the angle theta of tan(theta / 2) = spin / 2 (Hughes and Winget 1980),
     * which is the exact one if `spin` is that of the increment's middle.
     */
    static StressRotation
    hughes_winget(const Number &spin)
    {
      const StressRotation half = half_hughes_winget(spin);
      return {half.cosine * half.cosine - half.sine * half.sine,
              Number(2.) * half.sine * half.cosine};
    }

    /// Half as far: from the middle of the step to its end.
    static StressRotation
    half_hughes_winget(const Number &spin)
    {
      const Number t       = Number(0.5) * spin;
      const Number inverse = Number(1.) / (Number(1.) + t * t);
      return {(Number(1.) - t * t) * inverse, Number(2.) * t * inverse};
    }
  };

  /// @tparam Rotation  StressRotation of the stress's number type, or of double
  ///                   for a rotation that all lanes share.
  template <typename Number, typename Rotation>
  SymmetricTensorOf<Number>
  rotate(const SymmetricTensorOf<Number> &stress, const Rotation &rotation)
  {
    const Number half(0.5);
    const Number mean  = half * (stress[Component::xx] + stress[Component::yy]);
    const Number d     = half * (stress[Component::xx] - stress[Component::yy]);
    const Number t     = stress[Component::xy];
    const Number new_d = rotation.cosine * d - rotation.sine * t;
    const Number new_t = rotation.sine * d + rotation.cosine * t;
    return {mean + new_d, mean - new_d, stress[Component::zz], new_t};
  }
} // namespace Sandglass

#endif
