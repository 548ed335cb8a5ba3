#include <deal.II/base/utilities.h>

#include <sandglass/output/json_object.h>
#include <sandglass/output/summary.h>
#include <sandglass/output/timing.h>
#include <sandglass/version.h>

#include <cmath>
#include <limits>

namespace Sandglass
{
  double
  Summary::mass_balance_error() const
  {
    return initial_mass > 0. ?
             std::abs(totals.mass() - initial_mass) / initial_mass :
             0.;
  }



  double
  Summary::residual_mass() const
  {
    return std::isnan(flow.discharge_time) ?
             std::numeric_limits<double>::quiet_NaN() :
             totals.mass_in_silo;
  }



  void
  Summary::add_static_effort(JsonObject &json) const
  {
    const auto count = [](const unsigned int n) -> unsigned long { return n; };
    json.add("static_unknowns", count(static_effort->n_unknowns));
    json.add("static_solver",
             std::string(static_effort->is_direct ? "direct" : "multigrid"));
    json.add("static_newton_iterations",
             count(static_effort->n_newton_iterations));
    json.add("static_linear_iterations",
             count(static_effort->n_linear_iterations));
  }



  void
  Summary::add_flow(JsonObject &json) const
  {
    json.add("flow_rate_plateau_kg_per_s", flow.plateau);
    json.add("steady_flow_start_s", flow.steady.start);
    json.add("steady_flow_end_s", flow.steady.end);
    json.add("steady_flow_rate_kg_per_s", flow.steady.rate);
    json.add("discharge_time_s", flow.discharge_time);
    json.add("residual_mass_kg", residual_mass());
    if (flow.stagnant_mass)
      json.add("stagnant_mass_kg", *flow.stagnant_mass);
    json.add("slipping_wall_share", flow.slipping_wall_share);
  }



  std::string
  Summary::to_json(const std::string &status,
                   const std::string &message,
                   const TimerOutput &timings) const
  {
    const double loop_seconds = Timing::seconds(timings, Timing::particle_loop);

    JsonObject json;
    json.add("status", status);
    if (!message.empty())
      json.add("message", message);
    json.add("version", SANDGLASS_VERSION);
    json.add("git_hash", SANDGLASS_GIT_HASH);
    json.add("ranks", static_cast<unsigned long>(n_ranks));
    json.add("particles", n_particles);
    json.add("particles_now", totals.n_particles);
    json.add("cells", n_cells);
    json.add("steps", clock.step);
    json.add("particle_steps", totals.particle_steps);
    json.add("setup_seconds", Timing::seconds(timings, Timing::set_up));
    json.add("static_seconds", Timing::seconds(timings, Timing::static_stage));
    json.add("loop_seconds", loop_seconds);
    json.add("output_seconds", Timing::seconds(timings, Timing::output));
    json.add("particle_steps_per_second", totals.particle_steps / loop_seconds);
    if (static_effort)
      add_static_effort(json);
    json.add("peak_rss_MiB", peak_memory);
    json.add("mass_initial_kg", initial_mass);
    json.add("mass_in_silo_kg", totals.mass_in_silo);
    json.add("mass_discharged_kg", totals.mass_discharged());
    json.add("mass_lost_kg", totals.mass_lost);
    json.add("mass_balance_error", mass_balance_error());
    if (has_flow_rate)
      add_flow(json);
    json.add("end_time_s", clock.time);
    return json.text();
  }



  double
  peak_memory()
  {
    Utilities::System::MemoryStats statistics;
    Utilities::System::get_memory_stats(statistics);
    return statistics.VmHWM / 1024.;
  }
} // namespace Sandglass
