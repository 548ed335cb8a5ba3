#include <deal.II/base/mpi.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/output/history.h>
#include <sandglass/output/silo_measures.h>
#include <sandglass/scene/outlets.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    template <int dim>
    bool
    have_moving(const std::vector<Wall<dim>> &walls)
    {
      return std::any_of(walls.begin(), walls.end(), [](const Wall<dim> &wall) {
        return wall.velocity.norm() > 0.;
      });
    }



    /// A row of a run with as many outlets.
    template <int dim>
    FlowRateRow
    example_of_flow_rate(const Scene<dim> &scene)
    {
      FlowRateRow       row{};
      const std::size_t n_outlets = find_outlets(scene.mesh).size();
      row.mass_by_outlet.resize(n_outlets > 1 ? n_outlets : 0);
      return row;
    }



    /// A row of a run that asks for the stagnant mass or doesn't.
    HistoryRow
    example_row(const bool has_stagnant_mass,
                const bool is_fed,
                const bool has_moving_walls)
    {
      HistoryRow row{};
      row.is_fed           = is_fed;
      row.has_moving_walls = has_moving_walls;
      if (has_stagnant_mass)
        row.pattern.stagnant_mass = 0.;
      return row;
    }



    template <int dim>
    double
    stagnant_displacement(const OutputParameters  &parameters,
                          const SiloMeasures<dim> &measures)
    {
      return measures.has_open_outlet ?
               parameters.stagnant_displacement * measures.outlet_width :
               0.;
    }
  } // namespace



  template <int dim>
  History::History(const OutputParameters   &parameters,
                   const Scene<dim>         &scene,
                   const MaterialParameters &material,
                   const bool                is_fed)
    : is_writer(Utilities::MPI::this_mpi_process(scene.communicator) == 0)
    , has_open_outlet(SiloMeasures<dim>(scene).has_open_outlet)
    , largest_stagnant_displacement(
        Sandglass::stagnant_displacement(parameters, SiloMeasures<dim>(scene)))
    , history_file(parameters.directory + "/history.csv",
                   history_table,
                   example_row(largest_stagnant_displacement > 0.,
                               is_fed,
                               have_moving(scene.walls)))
    , flow_rate_file(parameters.directory + "/flow_rate.csv",
                     flow_rate_table,
                     example_of_flow_rate(scene))
    , flow_rate(parameters.flow_rate_window)
  {
    const SiloMeasures<dim> measures(scene);
    for (unsigned int i = 0; i < beverloo.size(); ++i)
      beverloo[i] = measures.beverloo_flow_rate(material.density,
                                                scene.gravity.norm(),
                                                0.1 * i);
  }



  void
  History::open()
  {
    if (!is_writer)
      return;
    history_file.open();
    if (has_open_outlet)
      flow_rate_file.open();
  }



  void
  History::refuse_other(const std::string &directory) const
  {
    if (!is_writer)
      return;
    history_file.refuse_other(directory);
    flow_rate_file.refuse_other(directory);
  }



  void
  History::add(const HistoryRow &row)
  {
    if (!is_writer)
      return;
    history_file.add_row(row);
    history_file.flush();

    if (!has_open_outlet)
      return;
    const double time = row.clock.time;
    const double mass = row.totals.mass_discharged();
    slipping_samples.emplace_back(time, row.pattern.slipping_wall_share);
    stagnant_mass = row.pattern.stagnant_mass.value_or(0.);
    flow_rate.add(time, mass);
    flow_rate_file.add_row(
      {time, mass, flow_rate.current(), beverloo, row.totals.mass_by_outlet});
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



#define INSTANTIATE(dim)                                \
  template History::History(const OutputParameters &,   \
                            const Scene<dim> &,         \
                            const MaterialParameters &, \
                            const bool);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
