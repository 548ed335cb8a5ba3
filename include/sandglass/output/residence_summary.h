#ifndef sandglass_output_residence_summary_h
#define sandglass_output_residence_summary_h

namespace Sandglass
{
  /// The residence of all material, for summary.json. NaN where nothing has
  /// left.
  struct ResidenceSummary
  {
    double mean_time, spread; ///< of what has left, in s

    /// Of the pairs of raster cells one above the other of which at least one
    /// has emptied by half, the share in which the lower one did first.
    double in_order_share;
  };
} // namespace Sandglass

#endif
