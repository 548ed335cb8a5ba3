#include <sandglass/output/history.h>

namespace Sandglass
{
  const std::vector<Column<HistoryRow>> history_table = {
    {"time_s",
     "s",
     [](const HistoryRow &r) { return r.clock.time; },
     "simulated time"},
    {"step",
     "1",
     [](const HistoryRow &r) { return r.clock.step; },
     "steps so far"},
    {"time_step_s",
     "s",
     [](const HistoryRow &r) { return r.clock.time_step; },
     "the last one"},
    {"time_step_over_critical",
     "1",
     [](const HistoryRow &r) {
       return r.clock.time_step / r.critical_time_step;
     },
     "the last step over the largest stable one: exactly in the rows that come "
     "with a file of fields, and with the automatic step otherwise over the "
     "critical step that it was chosen by, at most `Particle stage/Time step "
     "interval` steps before"},
    {"kinetic_energy_J",
     "J",
     [](const HistoryRow &r) { return r.totals.kinetic_energy; },
     "of all material"},
    {"elastic_energy_J",
     "J",
     [](const HistoryRow &r) { return r.totals.elastic_energy; },
     "of all material"},
    {"dissipated_energy_J",
     "J",
     [](const HistoryRow &r) { return r.totals.dissipated_energy; },
     "by plastic flow and wall friction, since the start"},
    {"momentum_x_kg_m_per_s",
     "kg m/s",
     [](const HistoryRow &r) { return r.totals.momentum[0]; },
     "of the computed section, since the whole silo's vanishes where only half "
     "of it is computed"},
    {"momentum_y_kg_m_per_s",
     "kg m/s",
     [](const HistoryRow &r) { return r.totals.momentum[1]; },
     "upwards"},
    {"mass_in_silo_kg",
     "kg",
     [](const HistoryRow &r) { return r.totals.mass_in_silo; },
     "above the outlet level"},
    {"mass_falling_kg",
     "kg",
     [](const HistoryRow &r) { return r.totals.mass_falling; },
     "the part of the discharged mass that is still in the fall region"},
    {"mass_discharged_kg",
     "kg",
     [](const HistoryRow &r) { return r.totals.mass_discharged(); },
     "all that has passed the outlet level"},
    {"mass_lost_kg",
     "kg",
     [](const HistoryRow &r) { return r.totals.mass_lost; },
     "that left the grid elsewhere than through the fall region's sides and "
     "bottom"},
    {"mass_fed_kg",
     "kg",
     [](const HistoryRow &r) { return r.totals.mass_fed; },
     "that has entered since the start; with `Feed/Kind` other than `none`",
     [](const HistoryRow &r) { return r.is_fed; }},
    {"wall_work_J",
     "J",
     [](const HistoryRow &r) { return r.totals.wall_work; },
     "that moving walls have done on the material since the start; its growth "
     "over time is the power of a belt. With `Walls/Velocities`",
     [](const HistoryRow &r) { return r.has_moving_walls; }},
    {"largest_speed_m_per_s",
     "m/s",
     [](const HistoryRow &r) { return r.totals.largest_speed; },
     "of the particles"},
    {"slipping_wall_share",
     "1",
     [](const HistoryRow &r) { return r.pattern.slipping_wall_share; },
     "share of the area of walls, floors and hoppers in contact at that step "
     "where the material slides; `nan` at t = 0"},
    {"stagnant_mass_kg",
     "kg",
     [](const HistoryRow &r) { return *r.pattern.stagnant_mass; },
     "mass in the silo that is at most `Output/Stagnant displacement` (0.1 "
     "outlet widths) from where it was before the static stage; that includes "
     "what has not begun to move, and the settlement at rest counts as motion. "
     "0 leaves the column out",
     [](const HistoryRow &r) { return r.pattern.stagnant_mass.has_value(); }}};



  namespace
  {
    /// What has come through one of several outlets, for the first eight.
    template <unsigned int outlet>
    Column<FlowRateRow>
    outlet_column(const char *name)
    {
      return {name,
              "kg",
              [](const FlowRateRow &r) { return r.mass_by_outlet[outlet]; },
              "the part of the discharged mass that has passed this outlet, "
              "counted from the left; where there are so many",
              [](const FlowRateRow &r) {
                return r.mass_by_outlet.size() > outlet;
              }};
    }
  } // namespace



  const std::vector<Column<FlowRateRow>> flow_rate_table = {
    {"time_s",
     "s",
     [](const FlowRateRow &r) { return r.time; },
     "simulated time"},
    {"discharged_mass_kg",
     "kg",
     [](const FlowRateRow &r) { return r.discharged_mass; },
     "all that has passed the outlet level"},
    {"mass_flow_rate_kg_per_s",
     "kg/s",
     [](const FlowRateRow &r) { return r.rate; },
     "the difference of that mass over `Output/Flow rate window`"},
    {"beverloo_0_kg_per_s",
     "kg/s",
     [](const FlowRateRow &r) { return r.beverloo[0]; },
     "Beverloo's rate for grains that are small beside the outlet"},
    {"beverloo_0.1_kg_per_s",
     "kg/s",
     [](const FlowRateRow &r) { return r.beverloo[1]; },
     "the same for grains of 0.1 outlet widths"},
    {"beverloo_0.2_kg_per_s",
     "kg/s",
     [](const FlowRateRow &r) { return r.beverloo[2]; },
     "the same for grains of 0.2 outlet widths"},
    outlet_column<0>("discharged_mass_outlet_1_kg"),
    outlet_column<1>("discharged_mass_outlet_2_kg"),
    outlet_column<2>("discharged_mass_outlet_3_kg"),
    outlet_column<3>("discharged_mass_outlet_4_kg"),
    outlet_column<4>("discharged_mass_outlet_5_kg"),
    outlet_column<5>("discharged_mass_outlet_6_kg"),
    outlet_column<6>("discharged_mass_outlet_7_kg"),
    outlet_column<7>("discharged_mass_outlet_8_kg")};
} // namespace Sandglass
