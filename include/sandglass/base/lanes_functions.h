#ifndef sandglass_base_lanes_functions_h
#define sandglass_base_lanes_functions_h

#include <sandglass/base/lanes.h>

#include <cstdint>
#include <cstring>
#include <limits>

namespace Sandglass
{
  /**
   * exp, log and pow of Lanes or of one double, by the same operations in the
   * same order: a lane's result is that of the double, bit by bit, whatever
   * the instruction set. They don't branch and agree with those of <cmath> to
   * 1e-13, relative.
   *
   * Their names are words since `exp` of a double would stand before the
   * system's wherever this file is included.
   */
  namespace LanesFunctions
  {
    inline std::uint64_t
    bits_of(const double a)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &a, sizeof(bits));
      return bits;
    }

    template <typename Number>
    struct FromBits
    {
      static Number
      make(const Lanes::Bits &bits)
      {
        return Number::from_bits(bits);
      }
    };

    template <>
    struct FromBits<double>
    {
      static double
      make(const std::uint64_t bits)
      {
        double a;
        std::memcpy(&a, &bits, sizeof(a));
        return a;
      }
    };

    /// Added to a number below 2^51 and subtracted again, it leaves the nearest
    /// integer; in between, the sum's lowest bits are that integer.
    constexpr double rounding_shift = 6755399441055744.; // 1.5 * 2^52

    constexpr unsigned int  n_mantissa_bits = 52;
    constexpr std::uint64_t exponent_bias   = 1023;

    /// log(2) as the sum of one number with 20 zeros at its end, whose product
    /// with an exponent is exact, and a small one.
    constexpr double log_2_upper = 6.93147180369123816490e-01;
    constexpr double log_2_lower = 1.90821492927058770002e-10;

    /// exp(r) for |r| <= log(2) / 2: the Taylor series up to r^11. What follows
    /// is less than 1e-14.
    template <typename Number>
    Number
    exponential_series(const Number &r)
    {
      // Pairs of terms don't wait for each other.
      const Number r2 = r * r;
      const Number r4 = r2 * r2;
      const Number terms_0_to_3 =
        (Number(1.) + r) + r2 * (Number(1. / 2.) + r * Number(1. / 6.));
      const Number terms_4_to_7 =
        (Number(1. / 24.) + r * Number(1. / 120.)) +
        r2 * (Number(1. / 720.) + r * Number(1. / 5040.));
      const Number terms_8_to_11 =
        (Number(1. / 40320.) + r * Number(1. / 362880.)) +
        r2 * (Number(1. / 3628800.) + r * Number(1. / 39916800.));
      return terms_0_to_3 + r4 * (terms_4_to_7 + r4 * terms_8_to_11);
    }

    /// log((1 + s) / (1 - s)) / (2 s) as a function of z = s^2 <= 0.0295: the
    /// series up to z^7. What follows is less than 4e-14.
    template <typename Number>
    Number
    logarithm_series(const Number &z)
    {
      const Number z2 = z * z;
      const Number z4 = z2 * z2;
      return ((Number(1.) + z * Number(1. / 3.)) +
              z2 * (Number(1. / 5.) + z * Number(1. / 7.))) +
             z4 * ((Number(1. / 9.) + z * Number(1. / 11.)) +
                   z2 * (Number(1. / 13.) + z * Number(1. / 15.)));
    }
  } // namespace LanesFunctions

  /// exp(x). Infinite above x = 709, zero below -708, where the true result is
  /// close to the ends of double's range.
  template <typename Number>
  Number
  exponential(const Number &x)
  {
    using namespace LanesFunctions;
    // x = k log(2) + r, exp(x) = 2^k exp(r)
    const Number shifted =
      x * Number(1.44269504088896338700) + Number(rounding_shift);
    const Number k = shifted - Number(rounding_shift);
    const Number r = (x - k * Number(log_2_upper)) - k * Number(log_2_lower);
    const Number power_of_two = FromBits<Number>::make(
      (bits_of(shifted) + exponent_bias) << n_mantissa_bits);

    const Number result = power_of_two * exponential_series(r);
    return select(x < Number(-708.),
                  Number(0.),
                  select(x > Number(709.),
                         Number(std::numeric_limits<double>::infinity()),
                         result));
  }

  /// Natural logarithm. Numbers below 2.3e-308 count as zero; not a number for
  /// negative ones.
  template <typename Number>
  Number
  logarithm(const Number &x)
  {
    using namespace LanesFunctions;
    using Limits = std::numeric_limits<double>;

    // x = 2^k m with m from sqrt(1/2) to sqrt(2). Subtracting the bits of
    // sqrt(1/2) moves the numbers at which the exponent changes to there.
    constexpr std::uint64_t root_bits     = 0x3fe6a09e00000000;
    constexpr std::uint64_t one_bits      = exponent_bias << n_mantissa_bits;
    constexpr std::uint64_t mantissa_bits = (1ul << n_mantissa_bits) - 1;
    const auto              moved         = bits_of(x) + (one_bits - root_bits);
    const Number            m =
      FromBits<Number>::make((moved & mantissa_bits) + root_bits);
    // The exponent as the lowest bits of a number of size 2^52.
    constexpr double        two_to_52      = 4503599627370496.;
    constexpr std::uint64_t two_to_52_bits = (exponent_bias + n_mantissa_bits)
                                             << n_mantissa_bits;
    const Number k =
      FromBits<Number>::make((moved >> n_mantissa_bits) | two_to_52_bits) -
      Number(two_to_52 + double(exponent_bias));

    const Number s = (m - Number(1.)) / (m + Number(1.));
    const Number result =
      k * Number(log_2_upper) +
      (k * Number(log_2_lower) + Number(2.) * s * logarithm_series(s * s));
    return select(x < Number(Limits::min()),
                  select(x < Number(0.),
                         Number(Limits::quiet_NaN()),
                         Number(-Limits::infinity())),
                  select(x <= Number(Limits::max()), result, x));
  }

  /// x to the power y for x >= 0; the relative error grows as |y log(x)|.
  template <typename Number>
  Number
  power(const Number &x, const Number &y)
  {
    return exponential(y * logarithm(x));
  }
} // namespace Sandglass

#endif
