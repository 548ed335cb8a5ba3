#ifndef sandglass_tests_hypoplastic_fixture_h
#define sandglass_tests_hypoplastic_fixture_h

#include <gtest/gtest.h>

#include "hypoplastic_reference.h"
#include "random_engine.h"

/// What tests of hypoplastic laws share: random states, and a test of all laws.
namespace HypoplasticReference
{
  /// As a kinematics gives it to a law.
  struct Increment
  {
    SymmetricComponents<6> strain;
  };

  /// Random states and increments.
  class Draw
  {
  public:
    explicit Draw(const unsigned int seed)
      : engine(random_engine(seed))
    {}

    double
    number(const double from, const double to)
    {
      return std::uniform_real_distribution<double>(from, to)(engine);
    }

    /// Of norm one.
    SymmetricComponents<6>
    direction()
    {
      std::normal_distribution<double> normal;
      SymmetricComponents<6>           result;
      for (int c = 0; c < 6; ++c)
        result[c] = normal(engine) * (c < 3 ? 1. : std::sqrt(0.5));
      return result / std::sqrt(double_contraction(result, result));
    }

    Matrix
    rotation()
    {
      const Matrix any = matrix(direction());
      return Eigen::SelfAdjointEigenSolver<Matrix>(any).eigenvectors();
    }

    /// With principal values from a fifth of the largest one, which is between
    /// 10 Pa and 1 MPa.
    SymmetricComponents<6>
    stress()
    {
      const double largest = std::pow(10., number(1., 6.));
      const auto   turn    = rotation();
      const Matrix principal =
        -largest * Eigen::Vector3d(1., number(0.2, 1.), number(0.2, 1.))
                     .asDiagonal()
                     .toDenseMatrix();
      return components(turn * principal * turn.transpose());
    }

    double
    void_ratio()
    {
      return number(0.72, 1.0);
    }

  private:
    std::mt19937 engine;
  };

  template <typename Law>
  class HypoplasticTest : public testing::Test
  {
  protected:
    const Law law = Law(MaterialConstants{});

    double
    scale(const SymmetricComponents<6> &stress) const
    {
      return pressure(stress) + 10. * law.small_pressure;
    }
  };

  using Laws = testing::Types<VonWolffersdorff, WuBauer, Kolymbas>;
} // namespace HypoplasticReference

#endif
