#ifndef sandglass_element_test_run_element_test_h
#define sandglass_element_test_run_element_test_h

#include <sandglass/output/log.h>
#include <sandglass/run/parameters.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * The law alone, at one material point: element_test.csv and summary.json in
   * the output directory. Rank 0 does the work. Collective. Throws InputError
   * before anything is written, RunError when the test can't go on; the rows so
   * far are kept.
   */
  void
  run_element_test(const Parameters               &parameters,
                   const std::vector<std::string> &warnings,
                   const MPI_Comm                  communicator,
                   Log                            &log);
} // namespace Sandglass

#endif
