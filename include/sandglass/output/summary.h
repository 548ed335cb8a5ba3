#ifndef sandglass_output_summary_h
#define sandglass_output_summary_h

#include <sandglass/base/table.h>
#include <sandglass/continuum/formulation.h>
#include <sandglass/flow/updated_lagrangian/static_state.h>
#include <sandglass/output/flow_kind.h>
#include <sandglass/output/flow_summary.h>
#include <sandglass/output/largest_pressure.h>
#include <sandglass/output/residence_summary.h>
#include <sandglass/output/silo_totals.h>
#include <sandglass/output/summary_file.h>
#include <sandglass/scene/resolution.h>

#include <optional>
#include <string>
#include <vector>

namespace Sandglass
{
  /// What a run was and did, for summary.json.
  struct Summary
  {
    std::string status = Status::running;
    std::string message; ///< what ended the run before its time, or empty
    /// What has ended a run that has finished; else empty.
    std::string ended_by;

    Formulation   formulation = Formulation::plane_strain;
    unsigned int  n_ranks     = 1;
    unsigned long n_particles = 0; ///< at the start
    unsigned long n_cells     = 0;
    Resolution    resolution;

    Clock      clock;
    SiloTotals totals;
    double     initial_mass = 0.; ///< in kg

    /// Effort of the static stage in this process; none after a restart.
    std::optional<StaticEffort> static_effort;

    /// Wall time of this process, in s.
    struct Seconds
    {
      double set_up = 0., static_stage = 0., particle_loop = 0., output = 0.;
    };

    Seconds seconds;

    /// Whether material can leave, enter, or be carried by walls.
    bool        has_flow_rate    = false;
    bool        is_fed           = false;
    bool        has_moving_walls = false;
    FlowSummary flow;

    /// On rank 0, where material can leave.
    std::optional<FlowKind> flow_kind;
    /// On rank 0, where residence is asked for.
    std::optional<ResidenceSummary> residence;

    /// On rank 0, where wall tractions are written.
    std::optional<LargestPressure> largest_pressure;

    /// Largest memory of the processes so far, summed over ranks, in MiB.
    double peak_memory = 0.;

    /// Difference between the sum of all masses and what was there at the start
    /// or has entered since, over that.
    double
    mass_balance_error() const;

    /// Mass in the silo once the flow has ended, in kg; NaN before.
    double
    residual_mass() const;

    /// The initial mass less that, in kg.
    double
    live_mass() const
    {
      return initial_mass - residual_mass();
    }
  };

  /// Keys of summary.json.
  extern const std::vector<Column<Summary>> summary_table;

  /// Largest memory of this process so far, in MiB.
  double
  peak_memory();
} // namespace Sandglass

#endif
