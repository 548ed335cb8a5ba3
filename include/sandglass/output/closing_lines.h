#ifndef sandglass_output_closing_lines_h
#define sandglass_output_closing_lines_h

#include <sandglass/output/summary.h>

#include <array>
#include <string>

namespace Sandglass
{
  /**
   * What a run that has come to its end tells on the screen: the masses, the
   * flow rate beside Beverloo's, the largest pressure on the walls, and how to
   * go on.
   *
   * @param beverloo  rates for grains of 0, 0.1 and 0.2 outlet widths, in
   *                  kg/s, see FlowRateRow.
   */
  std::string
  closing_lines(const Summary               &summary,
                const std::array<double, 3> &beverloo,
                const std::string           &directory);

  /// The command that makes a page of an output directory.
  std::string
  report_command(const std::string &directory);
} // namespace Sandglass

#endif
