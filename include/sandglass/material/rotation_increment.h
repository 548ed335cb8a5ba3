#ifndef sandglass_material_rotation_increment_h
#define sandglass_material_rotation_increment_h

#include <sandglass/continuum/in_plane_rotation.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

/**
 * A step's rotation as a few numbers, for laws that have to know it although
 * the stress has been turned already: rotation_numbers() packs it, so that it
 * can be part of a prediction, and rotation_matrix() unpacks it. A rotation in
 * space needs an overload of rotation_numbers() beside its class, which gives
 * the nine entries of its matrix.
 */
namespace Sandglass
{
  template <typename Number>
  std::array<Number, 2>
  rotation_numbers(const InPlaneRotation<Number> &rotation)
  {
    return {{rotation.cosine, rotation.sine}};
  }

  inline Eigen::Matrix3d
  rotation_matrix(const std::array<double, 0> &)
  {
    return Eigen::Matrix3d::Identity();
  }

  /// Of the cosine and sine of the double angle, which forward Euler makes a
  /// little longer than one.
  inline Eigen::Matrix3d
  rotation_matrix(const std::array<double, 2> &numbers)
  {
    const double angle = 0.5 * std::atan2(numbers[1], numbers[0]);
    return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())
      .toRotationMatrix();
  }

  /// Of the matrix's entries, row by row.
  inline Eigen::Matrix3d
  rotation_matrix(const std::array<double, 9> &numbers)
  {
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    return Eigen::Map<const RowMajor>(numbers.data());
  }

  template <typename Increment, typename = void>
  struct HasRotation : std::false_type
  {};

  template <typename Increment>
  struct HasRotation<Increment,
                     std::void_t<decltype(std::declval<Increment>().rotation)>>
    : std::true_type
  {};

  /// The numbers of an increment's rotation; none if it has no rotation.
  template <typename Increment>
  auto
  rotation_numbers_of(const Increment &increment)
  {
    if constexpr (HasRotation<Increment>::value)
      return rotation_numbers(increment.rotation);
    else
      return std::
        array<typename std::decay_t<decltype(increment.strain)>::Scalar, 0>();
  }
} // namespace Sandglass

#endif
