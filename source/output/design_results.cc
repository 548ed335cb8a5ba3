#include <deal.II/base/mpi.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/output/design_results.h>
#include <sandglass/output/replace_file.h>
#include <sandglass/output/section_wall_gauge.h>
#include <sandglass/output/silo_measures.h>

#include <filesystem>
#include <utility>

namespace Sandglass
{
  template <int dim>
  DesignResults<dim>::DesignResults(const OutputParameters &parameters,
                                    const Scene<dim>       &scene)
    : directory(parameters.directory)
    , communicator(scene.communicator)
    , has_open_outlet(SiloMeasures<dim>(scene).has_open_outlet)
    , profile(flow_bands(scene))
    , residence(parameters, scene)
    , gauges(parameters, scene)
  {}



  template <int dim>
  void
  DesignResults<dim>::write_row(const double                     time,
                                const std::vector<WallTraction> &tractions)
  {
    gauges.write(time, [this, &tractions](const Point<3> &point) {
      return needs_tractions() ? traction_at(point, tractions) : WallPressure();
    });
  }



  template <int dim>
  std::function<void()>
  DesignResults<dim>::output(const double                     time,
                             const double                     discharged_mass,
                             const std::vector<WallTraction> &tractions)
  {
    profile.end_interval(discharged_mass);
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return []() {};

    std::vector<std::pair<std::string, std::string>> tables;
    if (!tractions.empty())
      tables.emplace_back("wall_envelope.csv",
                          wall_envelope_text(tractions, has_open_outlet));
    if (profile.is_on())
      tables.emplace_back("flow_profile.csv",
                          csv_text(flow_profile_table, profile.levels()));
    std::vector<ResidenceRow> rows;
    VtuPiece                  map;
    if (residence.is_on())
      {
        rows = residence.rows(time);
        map  = residence.map();
      }
    return [this,
            tables = std::move(tables),
            rows   = std::move(rows),
            map    = std::move(map)]() {
      for (const auto &[name, text] : tables)
        replace_file(directory + '/' + name, text);
      if (rows.empty())
        return;
      residence.write(rows);
      const std::string name = directory + "/residence.vtu";
      write_vtu(unfinished_name(name), map);
      std::filesystem::rename(unfinished_name(name), name);
    };
  }



  template <int dim>
  void
  DesignResults<dim>::summarise(Summary &summary) const
  {
    if (profile.is_on())
      summary.flow_kind = FlowKind(profile.levels());
    if (residence.is_on())
      summary.residence = residence.summary();
  }



  template <int dim>
  void
  DesignResults<dim>::open()
  {
    residence.open();
    gauges.open();
  }



  template <int dim>
  void
  DesignResults<dim>::refuse_other(const std::string &directory) const
  {
    residence.refuse_other(directory);
    gauges.refuse_other(directory);
  }



#define INSTANTIATE(dim) template class DesignResults<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
