#ifndef sandglass_study_convergence_results_h
#define sandglass_study_convergence_results_h

#include <sandglass/base/table.h>
#include <sandglass/output/summary_file.h>
#include <sandglass/scene/resolution.h>
#include <sandglass/study/extrapolation.h>

#include <limits>
#include <string>
#include <vector>

namespace Sandglass
{
  /// One run of a convergence study.
  struct ConvergenceRun
  {
    Resolution    resolution;
    double        refinement     = 1.;
    unsigned long n_cells        = 0;
    unsigned long particle_steps = 0;
    double        seconds        = 0.; ///< wall time

    /// In kg/s: mean over the study's window of time, and over the middle half
    /// of the discharged mass.
    double rate_in_window = 0., rate_on_plateau = 0.;
    /// Whether the flow had ended when the run did.
    bool has_emptied = false;
  };

  /// What a row of study.csv is read from.
  struct ConvergenceRow
  {
    ConvergenceRun run;
    double         flow_rate; ///< in kg/s
    double         error;     ///< share of the extrapolated rate
  };

  /// Columns of study.csv of a convergence study.
  extern const std::vector<Column<ConvergenceRow>> convergence_table;

  /// A convergence study so far.
  struct ConvergenceResults
  {
    std::string status = Status::running;
    std::string message; ///< of the error; empty if there was none

    /// Times in s between which rates are means.
    double window_start = 0., window_end = 0.;

    std::vector<ConvergenceRun> runs;

    /// Whether a silo has emptied, so that all rates are those of the plateau.
    bool
    uses_plateau() const;

    /// The runs' flow rates, in kg/s.
    std::vector<double>
    flow_rates() const;

    /// The rate on cells of size zero at the lip, in kg/s; not a number from
    /// fewer than three runs.
    Extrapolation
    extrapolated() const;

    std::vector<ConvergenceRow>
    rows() const;
  };

  /// Keys of a convergence study's summary.json.
  extern const std::vector<Column<ConvergenceResults>>
    convergence_summary_table;

  /// A rate as `1850 ± 30 kg/s (1.6 %)`.
  std::string
  to_text(const Extrapolation &rate);

  /// The table and the extrapolated rate for the screen.
  std::string
  to_text(const ConvergenceResults &results);

  /// Write study.csv, summary.json and, where a rate can be extrapolated,
  /// study.svg. On one rank. Throws RunError where they can't be written.
  void
  write(const ConvergenceResults &results, const std::string &directory);
} // namespace Sandglass

#endif
