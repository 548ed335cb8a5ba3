#ifndef sandglass_study_smallest_outlet_h
#define sandglass_study_smallest_outlet_h

#include <sandglass/base/table.h>
#include <sandglass/output/summary_file.h>
#include <sandglass/study/study.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// One outlet tried.
  struct OutletTrial
  {
    double half_width = 0.; ///< in m
    double flow_rate  = 0.; ///< in kg/s, towards the end of the run
    bool   flows      = false;
  };

  /// Columns of study.csv of a study of the smallest outlet.
  extern const std::vector<Column<OutletTrial>> smallest_outlet_table;

  /// A study of the smallest outlet so far.
  struct SmallestOutlet
  {
    std::string status = Status::running;
    std::string message; ///< of the error; empty if there was none

    std::vector<OutletTrial> trials; ///< in the order in which they were made

    // Jenike's design; not a number where it has none.
    double unconfined_strength = 0.; ///< in Pa
    double flow_factor         = 0.;
    double arching_width       = 0.; ///< in m
    double rathole_diameter    = 0.; ///< in m
    double mass_flow_limit     = 0.; ///< in degrees

    /// The widest outlet that the material arrests in; not a number if it flows
    /// in all.
    double
    largest_arrested() const;

    /// The narrowest outlet above it that the material flows in; not a number
    /// if there is none.
    double
    smallest_flowing() const;
  };

  /// Keys of such a study's summary.json.
  extern const std::vector<Column<SmallestOutlet>>
    smallest_outlet_summary_table;

  /**
   * Bisection of the outlet's width between flow and arrest, each run from
   * rest; the hopper keeps its slope. Material flows if in the last third of a
   * run it still leaves with a tenth of the rate rho sqrt(g) D^n that a
   * cohesionless one has about.
   */
  void
  study_smallest_outlet(Parameters          &parameters,
                        const CommandLine   &command_line,
                        const ParameterFile &file,
                        const MPI_Comm       communicator);
} // namespace Sandglass

#endif
