#ifndef sandglass_base_lanes_h
#define sandglass_base_lanes_h

#include <Eigen/Core>

#include <cmath>

namespace Sandglass
{
  /**
   * One number of each of four particles, on which the processor computes at
   * once. Functions that are templates on their number type take it in place
   * of double.
   *
   * GCC's and Clang's vector extension, unlike intrinsics, compiles to what the
   * surrounding function's target has: one AVX register or two of SSE (see
   * instruction_sets.h). The alignment is stated since GCC would take what the
   * target's registers need, and so functions for different targets would
   * expect different alignments of the same object.
   */
  class alignas(4 * sizeof(double)) Lanes
  {
  public:
    static constexpr unsigned int n = 4;

    using Vector = double __attribute__((vector_size(n * sizeof(double))));
    using Mask   = long __attribute__((vector_size(n * sizeof(long))));
    using Bits   = unsigned long __attribute__((vector_size(n * sizeof(long))));

    Lanes() = default;

    // Copied as a vector: the compiler's own copy would go through memory in
    // halves where a function's registers are wider than the file's.

    Lanes(const Lanes &other)
      : vector(other.vector)
    {}

    Lanes &
    operator=(const Lanes &other)
    {
      vector = other.vector;
      return *this;
    }

    Lanes(const double value)
      : vector{value, value, value, value}
    {}

    /// @param numbers  n of them, aligned to their size together.
    static Lanes
    load(const double *numbers)
    {
      return *reinterpret_cast<const Lanes *>(numbers);
    }

    void
    store(double *numbers) const
    {
      *reinterpret_cast<Lanes *>(numbers) = *this;
    }

    /// The numbers that have these bits.
    static Lanes
    from_bits(const Bits &bits)
    {
      Lanes result;
      result.vector = reinterpret_cast<Vector>(bits);
      return result;
    }

    friend Bits
    bits_of(const Lanes &a)
    {
      return reinterpret_cast<Bits>(a.vector);
    }

    double
    operator[](const unsigned int lane) const
    {
      return vector[lane];
    }

    Lanes &
    operator+=(const Lanes &other)
    {
      vector += other.vector;
      return *this;
    }

    Lanes &
    operator-=(const Lanes &other)
    {
      vector -= other.vector;
      return *this;
    }

    Lanes &
    operator*=(const Lanes &other)
    {
      vector *= other.vector;
      return *this;
    }

    friend Lanes
    operator+(Lanes a, const Lanes &b)
    {
      return a += b;
    }

    friend Lanes
    operator-(Lanes a, const Lanes &b)
    {
      return a -= b;
    }

    friend Lanes
    operator*(Lanes a, const Lanes &b)
    {
      return a *= b;
    }

    friend Lanes
    operator/(Lanes a, const Lanes &b)
    {
      a.vector /= b.vector;
      return a;
    }

    friend Lanes
    operator-(Lanes a)
    {
      a.vector = -a.vector;
      return a;
    }

    friend Mask
    operator<(const Lanes &a, const Lanes &b)
    {
      return a.vector < b.vector;
    }

    friend Mask
    operator>(const Lanes &a, const Lanes &b)
    {
      return a.vector > b.vector;
    }

    friend Mask
    operator<=(const Lanes &a, const Lanes &b)
    {
      return a.vector <= b.vector;
    }

    friend Mask
    operator>=(const Lanes &a, const Lanes &b)
    {
      return a.vector >= b.vector;
    }

    friend Mask
    operator!=(const Lanes &a, const Lanes &b)
    {
      return a.vector != b.vector;
    }

    /// In each lane: a where the condition is true, otherwise b. The value that
    /// is not chosen may be infinite or not a number.
    friend Lanes
    select(const Mask &condition, Lanes a, const Lanes &b)
    {
      a.vector = condition ? a.vector : b.vector;
      return a;
    }

    friend Lanes
    sqrt(Lanes a)
    {
      for (unsigned int lane = 0; lane < n; ++lane)
        a.vector[lane] = std::sqrt(a.vector[lane]);
      return a;
    }

    friend Lanes
    abs(const Lanes &a)
    {
      return select(a < Lanes(0.), -a, a);
    }

    /// The sums over the lanes of a, b, c and d, one in each lane.
    friend Lanes
    sums_of_four(const Lanes &a, const Lanes &b, const Lanes &c, const Lanes &d)
    {
      // Shuffle within half registers: shuffles across the middle are slow.
      const Vector ab =
        __builtin_shufflevector(a.vector, b.vector, 0, 4, 2, 6) +
        __builtin_shufflevector(a.vector, b.vector, 1, 5, 3, 7);
      const Vector cd =
        __builtin_shufflevector(c.vector, d.vector, 0, 4, 2, 6) +
        __builtin_shufflevector(c.vector, d.vector, 1, 5, 3, 7);
      Lanes result;
      result.vector = __builtin_shufflevector(ab, cd, 0, 1, 4, 5) +
                      __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
      return result;
    }

    friend double
    sum(const Lanes &a)
    {
      return (a.vector[0] + a.vector[1]) + (a.vector[2] + a.vector[3]);
    }

  private:
    Vector vector;
  };

  /// Like select() for Lanes: a where the condition is true, otherwise b.
  inline double
  select(const bool condition, const double a, const double b)
  {
    return condition ? a : b;
  }

  inline bool
  any(const bool condition)
  {
    return condition;
  }

  inline bool
  any(const Lanes::Mask &condition)
  {
    return (condition[0] | condition[1] | condition[2] | condition[3]) != 0;
  }

  inline bool
  all(const Lanes::Mask &condition)
  {
    return (condition[0] & condition[1] & condition[2] & condition[3]) != 0;
  }

  /**
   * The sums over the lanes of several numbers, in the order of sum(): four of
   * them at a time, which costs little more than one alone.
   */
  template <std::size_t n_values>
  void
  sum_lanes(const std::array<Lanes, n_values> &values,
            std::array<double, n_values>      &sums)
  {
    constexpr std::size_t n_in_fours = n_values - n_values % Lanes::n;
    for (std::size_t i = 0; i < n_in_fours; i += Lanes::n)
      {
        const Lanes four =
          sums_of_four(values[i], values[i + 1], values[i + 2], values[i + 3]);
        for (unsigned int lane = 0; lane < Lanes::n; ++lane)
          sums[i + lane] = four[lane];
      }
    for (std::size_t i = n_in_fours; i < n_values; ++i)
      sums[i] = sum(values[i]);
  }
} // namespace Sandglass

/// What Eigen has to know of a number type.
template <>
struct Eigen::NumTraits<Sandglass::Lanes> : Eigen::GenericNumTraits<double>
{
  using Real       = Sandglass::Lanes;
  using NonInteger = Sandglass::Lanes;
  using Nested     = Sandglass::Lanes;
  using Literal    = Sandglass::Lanes;

  enum
  {
    IsComplex             = 0,
    IsInteger             = 0,
    IsSigned              = 1,
    RequireInitialization = 0
  };
};

#endif
