#include <deal.II/base/mpi.h>

#include <sandglass/output/beverloo.h>
#include <sandglass/output/history.h>

#include <cmath>

namespace Sandglass
{
  namespace
  {
    std::vector<std::string>
    history_columns(const bool has_stagnant_mass)
    {
      std::vector<std::string> columns = {"time_s",
                                          "step",
                                          "time_step_s",
                                          "time_step_over_critical",
                                          "kinetic_energy_J",
                                          "elastic_energy_J",
                                          "dissipated_energy_J",
                                          "momentum_x_kg_m_per_s",
                                          "momentum_y_kg_m_per_s",
                                          "mass_in_silo_kg",
                                          "mass_falling_kg",
                                          "mass_discharged_kg",
                                          "mass_lost_kg",
                                          "largest_speed_m_per_s",
                                          "slipping_wall_share"};
      if (has_stagnant_mass)
        columns.push_back("stagnant_mass_kg");
      return columns;
    }



    const std::vector<std::string> flow_rate_columns = {
      "time_s",
      "discharged_mass_kg",
      "mass_flow_rate_kg_per_s",
      "beverloo_0_kg_per_s",
      "beverloo_0.1_kg_per_s",
      "beverloo_0.2_kg_per_s"};
  } // namespace



  History::History(const OutputParameters   &parameters,
                   const Scene              &scene,
                   const MaterialParameters &material)
    : is_writer(Utilities::MPI::this_mpi_process(scene.communicator) == 0)
    , measures(scene)
    , largest_stagnant_displacement(measures.has_open_outlet ?
                                      parameters.stagnant_displacement *
                                        measures.outlet_width :
                                      0.)
    , history_file(parameters.directory + "/history.csv",
                   history_columns(largest_stagnant_displacement > 0.))
    , flow_rate_file(parameters.directory + "/flow_rate.csv", flow_rate_columns)
    , flow_rate(parameters.flow_rate_window)
  {
    for (unsigned int i = 0; i < beverloo.size(); ++i)
      beverloo[i] = beverloo_flow_rate(scene.formulation,
                                       material.density,
                                       scene.gravity.norm(),
                                       measures.outlet_width,
                                       0.1 * i);
  }



  void
  History::open()
  {
    if (!is_writer)
      return;
    history_file.open();
    if (measures.has_open_outlet)
      flow_rate_file.open();
  }



  void
  History::observe(const Clock          &clock,
                   const double          critical_time_step,
                   const ParticleTotals &totals,
                   const FlowPattern    &pattern)
  {
    if (!is_writer)
      return;
    const auto add_row = [&](const auto &...more) {
      history_file.add_row(clock.time,
                           clock.step,
                           clock.time_step,
                           clock.time_step / critical_time_step,
                           totals.kinetic_energy,
                           totals.elastic_energy,
                           totals.dissipated_energy,
                           totals.momentum[0],
                           totals.momentum[1],
                           totals.mass_in_silo,
                           totals.mass_falling,
                           totals.mass_discharged(),
                           totals.mass_lost,
                           totals.largest_speed,
                           pattern.slipping_wall_share,
                           more...);
    };
    if (pattern.stagnant_mass)
      add_row(*pattern.stagnant_mass);
    else
      add_row();
    history_file.flush();

    if (!measures.has_open_outlet)
      return;
    slipping_samples.emplace_back(clock.time, pattern.slipping_wall_share);
    stagnant_mass = pattern.stagnant_mass.value_or(0.);
    flow_rate.add(clock.time, totals.mass_discharged());
    flow_rate_file.add_row(clock.time,
                           totals.mass_discharged(),
                           flow_rate.current(),
                           beverloo[0],
                           beverloo[1],
                           beverloo[2]);
    flow_rate_file.flush();
  }



  FlowSummary
  History::flow_summary() const
  {
    FlowSummary summary;
    summary.plateau        = flow_rate.plateau();
    summary.steady         = flow_rate.steady();
    summary.discharge_time = flow_rate.discharge_time();
    if (largest_stagnant_displacement > 0.)
      summary.stagnant_mass = stagnant_mass;

    const double start = flow_rate.time_of_share(0.25);
    const double end   = flow_rate.time_of_share(0.75);
    double       sum = 0., n = 0.;
    for (const auto &[time, share] : slipping_samples)
      if (time >= start && time <= end && !std::isnan(share))
        {
          sum += share;
          n += 1.;
        }
    summary.slipping_wall_share = sum / n;
    return summary;
  }
} // namespace Sandglass
