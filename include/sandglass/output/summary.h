#ifndef sandglass_output_summary_h
#define sandglass_output_summary_h

#include <deal.II/base/timer.h>

#include <sandglass/output/flow_summary.h>
#include <sandglass/output/json_object.h>
#include <sandglass/output/particle_totals.h>
#include <sandglass/flow/updated_lagrangian/static_state.h>

#include <optional>
#include <string>

namespace Sandglass
{
  /// What a run was and did, for summary.json.
  struct Summary
  {
    unsigned int  n_ranks     = 1;
    unsigned long n_particles = 0; ///< at the start
    unsigned long n_cells     = 0;

    Clock          clock;
    ParticleTotals totals;
    double         initial_mass = 0.; ///< in kg

    /// Of this process: none after a restart.
    std::optional<StaticState::Effort> static_effort;

    /// Whether material can leave.
    bool        has_flow_rate = false;
    FlowSummary flow;

    /// Largest memory of the processes so far, summed over ranks, in MiB.
    double peak_memory = 0.;

    /// Difference between the sum of all masses and the initial mass, over it.
    double
    mass_balance_error() const;

    /// Mass in the silo once the flow has ended, in kg; NaN before.
    double
    residual_mass() const;

    /**
     * The text of summary.json. Times and particle-steps are those of this
     * process; after a restart, `steps` counts those before it too.
     *
     * @param status   `running`, `finished` or `failed`
     * @param message  of the error; empty if there was none.
     */
    std::string
    to_json(const std::string &status,
            const std::string &message,
            const TimerOutput &timings) const;

  private:
    void
    add_static_effort(JsonObject &json) const;
    void
    add_flow(JsonObject &json) const;
  };

  /// Largest memory of this process so far, in MiB.
  double
  peak_memory();
} // namespace Sandglass

#endif
