#ifndef sandglass_output_normal_range_h
#define sandglass_output_normal_range_h

#include <limits>

namespace Sandglass
{
  /// What a wall has borne at one place so far, in Pa, compression positive;
  /// NaN where it is not known. Pressures in discharge are means over an
  /// interval of time, which ends at the time given, in s.
  struct NormalRange
  {
    static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

    double filling            = nothing; ///< at rest
    double filling_tangential = nothing;
    double largest            = nothing; ///< in discharge
    double largest_time       = nothing;
    /// Friction when the normal traction was largest.
    double largest_tangential = nothing;
    double smallest           = nothing; ///< in discharge, of a full silo
    double smallest_time      = nothing;

    /// The largest over the filling pressure.
    double
    ratio() const
    {
      return filling > 0. ? largest / filling : nothing;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &filling &filling_tangential &largest &largest_time
        &largest_tangential &smallest &smallest_time;
    }
  };
} // namespace Sandglass

#endif
