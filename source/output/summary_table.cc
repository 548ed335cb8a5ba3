#include <sandglass/output/summary.h>
#include <sandglass/version.h>

#include <cmath>

namespace Sandglass
{
  namespace
  {
    bool
    has_static_effort(const Summary &summary)
    {
      return summary.static_effort.has_value();
    }

    bool
    has_element_size(const Summary &summary)
    {
      return !std::isnan(summary.resolution.element_size);
    }

    bool
    has_flow_rate(const Summary &summary)
    {
      return summary.has_flow_rate;
    }

    bool
    has_flow_kind(const Summary &summary)
    {
      return summary.flow_kind.has_value();
    }

    bool
    has_residence(const Summary &summary)
    {
      return summary.residence.has_value();
    }

    bool
    has_pressure(const Summary &summary)
    {
      return summary.largest_pressure && summary.largest_pressure->is_known();
    }
  } // namespace



  const std::vector<Column<Summary>> summary_table = {
    {"status",
     "",
     [](const Summary &s) { return s.status; },
     "`running`, which a run that was killed stays; `finished`; `failed` with "
     "an error; `stopped` by a signal, with a checkpoint to go on from"},
    {"message",
     "",
     [](const Summary &s) { return s.message; },
     "what ended the run before its time",
     [](const Summary &s) { return !s.message.empty(); }},
    {"ended_by",
     "",
     [](const Summary &s) { return s.ended_by; },
     "what has ended a finished run: its end time, or an event of the section "
     "`Stop`",
     [](const Summary &s) { return !s.ended_by.empty(); }},
    {"version",
     "",
     [](const Summary &) { return std::string(SANDGLASS_VERSION); },
     "of Sandglass"},
    {"git_hash",
     "",
     [](const Summary &) { return std::string(SANDGLASS_GIT_HASH); },
     "of the commit that Sandglass was built from"},
    {"ranks",
     "1",
     [](const Summary &s) { return static_cast<unsigned long>(s.n_ranks); },
     "of MPI"},
    {"particles",
     "1",
     [](const Summary &s) { return s.n_particles; },
     "at the start"},
    {"particles_now",
     "1",
     [](const Summary &s) { return s.totals.n_particles; },
     "at the last row of `history.csv`; splitting makes more of them ([graded "
     "meshes](graded-meshes.md)), and what has fallen out of the grid is gone"},
    {"cells",
     "1",
     [](const Summary &s) { return s.n_cells; },
     "of the whole mesh"},
    {"element_size_m",
     "m",
     [](const Summary &s) { return s.resolution.element_size; },
     "`Scene/Element size`, given or chosen, over `Scene/Refinement`; not with "
     "a mesh file",
     has_element_size},
    {"outlet_element_size_m",
     "m",
     [](const Summary &s) { return s.resolution.smallest_size(); },
     "the same at the outlet's lip",
     has_element_size},
    {"particles_per_cell",
     "1",
     [](const Summary &s) {
       return static_cast<unsigned long>(s.resolution.particles_per_cell);
     },
     "at the start, in filled cells"},
    {"steps",
     "1",
     [](const Summary &s) { return s.clock.step; },
     "those before a restart too"},
    {"particle_steps",
     "1",
     [](const Summary &s) { return s.totals.particle_steps; },
     "particles times steps, since this process started"},
    {"setup_seconds",
     "s",
     [](const Summary &s) { return s.seconds.set_up; },
     "wall time of this process for mesh, grid and particles"},
    {"static_seconds",
     "s",
     [](const Summary &s) { return s.seconds.static_stage; },
     "for the static stage"},
    {"loop_seconds",
     "s",
     [](const Summary &s) { return s.seconds.particle_loop; },
     "for the steps"},
    {"output_seconds",
     "s",
     [](const Summary &s) { return s.seconds.output; },
     "for output"},
    {"particle_steps_per_second",
     "1/s",
     [](const Summary &s) {
       return s.totals.particle_steps / s.seconds.particle_loop;
     },
     "of the steps alone"},
    {"static_unknowns",
     "1",
     [](const Summary &s) {
       return static_cast<unsigned long>(s.static_effort->n_unknowns);
     },
     "of the static stage's equations; left out after a restart, as the next "
     "three",
     has_static_effort},
    {"static_solver",
     "",
     [](const Summary &s) {
       return std::string(s.static_effort->is_direct ? "direct" : "multigrid");
     },
     "how Newton's linear equations were solved: by factors (`direct`) or "
     "`multigrid`",
     has_static_effort},
    {"static_newton_iterations",
     "1",
     [](const Summary &s) {
       return static_cast<unsigned long>(s.static_effort->n_newton_iterations);
     },
     "in all load steps",
     has_static_effort},
    {"static_linear_iterations",
     "1",
     [](const Summary &s) {
       return static_cast<unsigned long>(s.static_effort->n_linear_iterations);
     },
     "in all load steps",
     has_static_effort},
    {"static_relaxation_steps",
     "1",
     [](const Summary &s) {
       return static_cast<unsigned long>(s.static_effort->n_relaxation_steps);
     },
     "of dynamic relaxation, which takes over where Newton's method finds no "
     "way; in all load steps",
     has_static_effort},
    {"peak_rss_MiB",
     "MiB",
     [](const Summary &s) { return s.peak_memory; },
     "largest memory of the processes, summed over the ranks"},
    {"mass_initial_kg",
     "kg",
     [](const Summary &s) { return s.initial_mass; },
     "at t = 0"},
    {"mass_in_silo_kg",
     "kg",
     [](const Summary &s) { return s.totals.mass_in_silo; },
     "above the outlet level"},
    {"mass_discharged_kg",
     "kg",
     [](const Summary &s) { return s.totals.mass_discharged(); },
     "all that has passed the outlet level"},
    {"mass_lost_kg",
     "kg",
     [](const Summary &s) { return s.totals.mass_lost; },
     "that left the grid elsewhere than through the fall region's sides and "
     "bottom"},
    {"mass_fed_kg",
     "kg",
     [](const Summary &s) { return s.totals.mass_fed; },
     "that has entered since t = 0; with `Feed/Kind` other than `none`",
     [](const Summary &s) { return s.is_fed; }},
    {"mass_balance_error",
     "1",
     [](const Summary &s) { return s.mass_balance_error(); },
     "difference between the sum of the masses in the silo, discharged and "
     "lost, and that of the initial mass and what has entered, over the "
     "latter"},
    {"wall_work_J",
     "J",
     [](const Summary &s) { return s.totals.wall_work; },
     "that moving walls have done on the material; with `Walls/Velocities`, as "
     "the next",
     [](const Summary &s) { return s.has_moving_walls; }},
    {"mean_wall_power_W",
     "W",
     [](const Summary &s) { return s.totals.wall_work / s.clock.time; },
     "this work over the simulated time: what drives a belt",
     [](const Summary &s) { return s.has_moving_walls; }},
    {"flow_rate_plateau_kg_per_s",
     "kg/s",
     [](const Summary &s) { return s.flow.plateau; },
     "mean rate over the middle half of the discharged mass; as all that "
     "follows up to `slipping_wall_share` where material can leave",
     has_flow_rate},
    {"steady_flow_start_s",
     "s",
     [](const Summary &s) { return s.flow.steady.start; },
     "begin of the longest stretch of time in which the flow rate of "
     "`flow_rate.csv` stays within 10 % of the middle between its largest and "
     "smallest value there. Where it is much shorter than the discharge there "
     "is no constant rate to speak of",
     has_flow_rate},
    {"steady_flow_end_s",
     "s",
     [](const Summary &s) { return s.flow.steady.end; },
     "its end",
     has_flow_rate},
    {"steady_flow_rate_kg_per_s",
     "kg/s",
     [](const Summary &s) { return s.flow.steady.rate; },
     "the mean rate over it",
     has_flow_rate},
    {"discharge_time_s",
     "s",
     [](const Summary &s) { return s.flow.discharge_time; },
     "when 99.9 % of all that had left the silo by the end of the run had left "
     "it. `null` if that is less than a `Output/Flow rate window` before the "
     "end: then material still flows",
     has_flow_rate},
    {"residual_mass_kg",
     "kg",
     [](const Summary &s) { return s.residual_mass(); },
     "what is left in the silo, once the flow has ended; else `null`",
     has_flow_rate},
    {"live_mass_kg",
     "kg",
     [](const Summary &s) { return s.live_mass(); },
     "what has left the silo by then, its live capacity; the residual mass is "
     "the dead one",
     has_flow_rate},
    {"stagnant_mass_kg",
     "kg",
     [](const Summary &s) { return *s.flow.stagnant_mass; },
     "the last one of `history.csv`, where that has it",
     [](const Summary &s) {
       return s.has_flow_rate && s.flow.stagnant_mass.has_value();
     }},
    {"slipping_wall_share",
     "1",
     [](const Summary &s) { return s.flow.slipping_wall_share; },
     "mean over the middle half of the discharged mass",
     has_flow_rate},
    {"kind_of_flow",
     "",
     [](const Summary &s) { return s.flow_kind->name; },
     "by `flow_profile.csv`, as EN 1991-4 names it: `mass flow`, or of funnel "
     "flow `mixed flow`, whose flow zone meets the wall below the surface, or "
     "`pipe flow`, in which it doesn't; empty where nothing flows",
     has_flow_kind},
    {"transition_height_m",
     "m",
     [](const Summary &s) { return s.flow_kind->transition; },
     "above the outlet level, up to which material stands beside a wall; `null` "
     "in mass flow",
     has_flow_kind},
    {"smallest_mass_flow_index",
     "1",
     [](const Summary &s) { return s.flow_kind->smallest_mass_flow_index; },
     "of `flow_profile.csv`",
     has_flow_kind},
    {"mean_residence_time_s",
     "s",
     [](const Summary &s) { return s.residence->mean_time; },
     "mean time when what has left passed the outlet level, with "
     "`Output/Residence` as the next two",
     has_residence},
    {"residence_time_spread_s",
     "s",
     [](const Summary &s) { return s.residence->spread; },
     "its standard deviation",
     has_residence},
    {"first_in_first_out_share",
     "1",
     [](const Summary &s) { return s.residence->in_order_share; },
     "of all pairs of cells of `residence.vtu` one above the other of which at "
     "least one has emptied by half, the share in which the lower one did "
     "first: 1 where what is filled first leaves first",
     has_residence},
    {"largest_wall_pressure_Pa",
     "Pa",
     [](const Summary &s) { return s.largest_pressure->pressure; },
     "the largest `normal_Pa` of `wall_traction.csv`, without that of an "
     "outlet before it opens; with the next four left out where there is none",
     has_pressure},
    {"largest_wall_pressure_wall",
     "",
     [](const Summary &s) { return s.largest_pressure->wall; },
     "on which wall it was",
     has_pressure},
    {"largest_wall_pressure_x_m",
     "m",
     [](const Summary &s) { return s.largest_pressure->x; },
     "where",
     has_pressure},
    {"largest_wall_pressure_y_m",
     "m",
     [](const Summary &s) { return s.largest_pressure->y; },
     "where",
     has_pressure},
    {"largest_wall_pressure_time_s",
     "s",
     [](const Summary &s) { return s.largest_pressure->time; },
     "when",
     has_pressure},
    {"end_time_s",
     "s",
     [](const Summary &s) { return s.clock.time; },
     "simulated time at the end"}};
} // namespace Sandglass
