#ifndef sandglass_base_compensated_sum_h
#define sandglass_base_compensated_sum_h

#include <cmath>

namespace Sandglass
{
  /// A sum of many small numbers as exact as one of two (Neumaier 1974).
  class CompensatedSum
  {
  public:
    CompensatedSum &
    operator+=(const double addend)
    {
      const double next = sum + addend;
      rest += std::abs(sum) >= std::abs(addend) ? (sum - next) + addend :
                                                  (addend - next) + sum;
      sum = next;
      return *this;
    }

    operator double() const
    {
      return sum + rest;
    }

    CompensatedSum &
    operator+=(const CompensatedSum &other)
    {
      *this += other.sum;
      return *this += other.rest;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &sum &rest;
    }

  private:
    double sum  = 0.;
    double rest = 0.; ///< what `sum` lacks
  };
} // namespace Sandglass

#endif
