#ifndef sandglass_material_stress_h
#define sandglass_material_stress_h

#include <Eigen/Core>

namespace Sandglass
{
  /**
   * The four components of a symmetric tensor that plane strain and axisymmetry
   * leave: (xx, yy, zz, xy), where zz is the out-of-plane or hoop component.
   * Stresses are in Pa, tension positive. The shear component is the tensor's,
   * not the engineering strain.
   */
  using SymmetricTensor4 = Eigen::Vector4d;

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
  inline double
  pressure(const SymmetricTensor4 &stress)
  {
    return -(stress[Component::xx] + stress[Component::yy] +
             stress[Component::zz]) /
           3.;
  }

  inline SymmetricTensor4
  deviator(const SymmetricTensor4 &stress)
  {
    const double p = pressure(stress);
    return stress + SymmetricTensor4(p, p, p, 0.);
  }

  /// a : b; the shear component counts twice.
  inline double
  double_contraction(const SymmetricTensor4 &a, const SymmetricTensor4 &b)
  {
    return a.dot(b) + a[Component::xy] * b[Component::xy];
  }

  /// q = sqrt(3/2 s : s) of the deviator s (paper, Section 2.2).
  inline double
  von_mises_stress(const SymmetricTensor4 &stress)
  {
    const SymmetricTensor4 s = deviator(stress);
    return std::sqrt(1.5 * double_contraction(s, s));
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
  struct StressRotation
  {
    double cosine = 1.;
    double sine   = 0.;

    /// As jaumann_rotation(): first order, the stress grows a little.
    static StressRotation
    forward_euler(const double spin)
    {
      return {1., 2. * spin};
    }

    /**
     * By the angle theta of tan(theta / 2) = spin / 2 (Hughes and Winget 1980),
     * which is the exact one if `spin` is that of the increment's middle.
     */
    static StressRotation
    hughes_winget(const double spin)
    {
      const StressRotation half = half_hughes_winget(spin);
      return {half.cosine * half.cosine - half.sine * half.sine,
              2. * half.sine * half.cosine};
    }

    /// Half as far: from the middle of the step to its end.
    static StressRotation
    half_hughes_winget(const double spin)
    {
      const double t = 0.5 * spin;
      return {(1. - t * t) / (1. + t * t), 2. * t / (1. + t * t)};
    }
  };

  inline SymmetricTensor4
  rotate(const SymmetricTensor4 &stress, const StressRotation &rotation)
  {
    const double mean  = 0.5 * (stress[Component::xx] + stress[Component::yy]);
    const double d     = 0.5 * (stress[Component::xx] - stress[Component::yy]);
    const double t     = stress[Component::xy];
    const double new_d = rotation.cosine * d - rotation.sine * t;
    const double new_t = rotation.sine * d + rotation.cosine * t;
    return {mean + new_d, mean - new_d, stress[Component::zz], new_t};
  }
} // namespace Sandglass

#endif
