#ifndef sandglass_study_convergence_plot_h
#define sandglass_study_convergence_plot_h

#include <sandglass/study/convergence_results.h>

#include <string>

namespace Sandglass
{
  /**
   * The flow rates over the size of the cells at the lip with the line through
   * them, and the extrapolated rate with its uncertainty, as the text of an SVG
   * file. Needs no display.
   *
   * @param results  of at least three runs.
   */
  std::string
  plot(const ConvergenceResults &results);
} // namespace Sandglass

#endif
