#include <sandglass/continuum/midpoint_stress_derivative.h>
#include <sandglass/continuum/solid_response.h>

#include <Eigen/Geometry>

namespace Sandglass
{
  namespace
  {
    using RowMajor  = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    using Matrix6x9 = Eigen::Matrix<double, 6, 9>;
    using Matrix9x6 = Eigen::Matrix<double, 9, 6>;

    /// The component of a symmetric tensor at row i and column j.
    constexpr int component_at[3][3] = {
      {Component::xx, Component::xy, Component::xz},
      {Component::xy, Component::yy, Component::yz},
      {Component::xz, Component::yz, Component::zz}};

    Eigen::Matrix3d
    deformation_gradient(const Gradient9 &H)
    {
      return Eigen::Matrix3d::Identity() + Eigen::Map<const RowMajor>(H.data());
    }

    Eigen::Matrix3d
    matrix_of(const SymmetricComponents<6> &stress)
    {
      Eigen::Matrix3d result;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result(i, j) = stress[component_at[i][j]];
      return result;
    }

    Gradient9
    numbers_of(const Eigen::Matrix3d &matrix)
    {
      Gradient9 result;
      Eigen::Map<RowMajor>(result.data()) = matrix;
      return result;
    }

    /// The permutation symbol.
    double
    sign_of(const int i, const int j, const int k)
    {
      return 0.5 * (i - j) * (j - k) * (k - i);
    }



    /// Derivative of the stress at the end of the step with respect to H.
    Matrix6x9
    stress_derivative(const SymmetricComponents<6> &stress_before,
                      const MaterialTangent<6>     &material)
    {
      Matrix6x9 derivative;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          {
            // H_ij = 1 alone is a shear strain of 1/2 and a spin of 1/2 about
            // the third axis.
            derivative.col(3 * i + j) =
              (i == j ? 1. : 0.5) * material.by_strain.col(component_at[i][j]);
            std::array<double, 3> spin{};
            for (int k = 0; k < 3; ++k)
              spin[k] = -0.5 * sign_of(i, j, k);
            if (i != j)
              derivative.col(3 * i + j) +=
                material.by_stress * jaumann_rotation(stress_before, spin);
          }
      return derivative;
    }



    /// Derivative of the Piola stress with respect to the stress at fixed H.
    Matrix9x6
    stress_sensitivity(const Gradient9 &H)
    {
      const Eigen::Matrix3d cofactor   = SolidResponse::cofactor(H);
      Matrix9x6             derivative = Matrix9x6::Zero();
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int k = 0; k < 3; ++k)
            derivative(3 * i + j, component_at[i][k]) += cofactor(k, j);
      return derivative;
    }



    /// Derivative of the Piola stress with respect to H at fixed stress.
    Matrix9
    geometric_tangent(const SymmetricComponents<6> &stress, const Gradient9 &H)
    {
      const Eigen::Matrix3d F          = deformation_gradient(H);
      const Eigen::Matrix3d sigma      = matrix_of(stress);
      Matrix9               derivative = Matrix9::Zero();
      // The cofactor C_kj = 1/2 e_kmn e_jpq F_mp F_nq is quadratic in F.
      for (int m = 0; m < 3; ++m)
        for (int p = 0; p < 3; ++p)
          {
            Eigen::Matrix3d of_cofactor = Eigen::Matrix3d::Zero();
            for (int k = 0; k < 3; ++k)
              for (int j = 0; j < 3; ++j)
                if (k != m && j != p)
                  {
                    const int n = 3 - k - m, q = 3 - j - p;
                    of_cofactor(k, j) =
                      sign_of(k, m, n) * sign_of(j, p, q) * F(n, q);
                  }
            derivative.col(3 * m + p) = numbers_of(sigma * of_cofactor);
          }
      return derivative;
    }
  } // namespace



  Eigen::Matrix3d
  SolidResponse::cofactor(const Gradient9 &H)
  {
    const Eigen::Matrix3d F = deformation_gradient(H);
    Eigen::Matrix3d       result;
    for (int i = 0; i < 3; ++i)
      result.row(i) = F.row((i + 1) % 3).cross(F.row((i + 2) % 3));
    return result;
  }



  double
  SolidResponse::volume_ratio(const Gradient9 &H)
  {
    return deformation_gradient(H).determinant();
  }



  SolidIncrement<double>
  SolidResponse::increment(const Gradient9        &H,
                           const StressIntegration integration)
  {
    SolidIncrement<double>::Gradient gradient;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        gradient[i][j] = H[3 * i + j];
    return {gradient, 0., integration};
  }



  Gradient9
  SolidResponse::piola_stress(const SymmetricComponents<6> &stress,
                              const Gradient9              &H)
  {
    return numbers_of(matrix_of(stress) * cofactor(H));
  }



  Matrix9
  SolidResponse::tangent(const SymmetricComponents<6> &stress_before,
                         const SymmetricComponents<6> &stress,
                         const Gradient9              &H,
                         const MaterialTangent<6>     &material,
                         const StressIntegration       integration)
  {
    const Matrix6x9 derivative =
      integration == StressIntegration::start_of_step ?
        stress_derivative(stress_before, material) :
        midpoint_stress_derivative<SolidResponse>(stress_before, H, material);
    return geometric_tangent(stress, H) + stress_sensitivity(H) * derivative;
  }
} // namespace Sandglass
