#include <deal.II/base/mpi.h>

#include <sandglass/flow/in_space.h>
#include <sandglass/output/section_corner_shares.h>
#include <sandglass/output/section_wall_tractions.h>
#include <sandglass/walls/section_tangent.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace Sandglass
{
  double
  WallTraction::tangential() const
  {
    const Tensor<1, 2> tangent =
      wall_tangent(Tensor<1, 2>({record.normal[0], record.normal[1]}));
    return on_material[0] * tangent[0] + on_material[1] * tangent[1];
  }



  WallTractions<2>::WallTractions(const OutputParameters   &parameters,
                                  const Scene<2>           &scene,
                                  const MaterialParameters &material)
    : scene(scene)
    , is_writer(Utilities::MPI::this_mpi_process(scene.communicator) == 0)
    , references(parameters, scene, material)
    , lines(scene.mesh, scene.walls, SiloMeasures<2>(scene).bottom_centre)
    , table(parameters.directory + "/wall_traction.csv",
            wall_columns(),
            WallTraction())
    , series(parameters.directory, "walls", MPI_COMM_SELF)
  {}



  void
  WallTractions<2>::open()
  {
    if (!is_writer)
      return;
    table.open();
    series.open();
  }



  void
  WallTractions<2>::refuse_other(const std::string &directory) const
  {
    if (is_writer)
      table.refuse_other(directory);
  }



  std::vector<WallTractions<2>::PlacedRecord>
  WallTractions<2>::collect(const WallRecords &records) const
  {
    std::vector<PlacedRecord> result;
    for (const auto &of_rank :
         Utilities::MPI::gather(scene.communicator, records.records))
      for (const WallRecord &record : of_rank)
        if (record.wall != no_wall)
          result.push_back({record, lines.find(record.wall, record.vertex)});

    const auto key = [this](const PlacedRecord &placed) {
      const WallRecord &record = placed.record;
      return std::make_tuple(scene.walls[record.wall].role,
                             record.wall,
                             placed.place.line,
                             placed.place.arc_length,
                             record.normal[0],
                             record.normal[1]);
    };
    std::sort(result.begin(),
              result.end(),
              [&key](const auto &a, const auto &b) { return key(a) < key(b); });
    order_at_bends(result);
    return result;
  }



  void
  WallTractions<2>::order_at_bends(std::vector<PlacedRecord> &sorted)
  {
    const auto of_one_line = [&sorted](const unsigned int i,
                                       const unsigned int j) {
      return j < sorted.size() &&
             sorted[i].record.wall == sorted[j].record.wall &&
             sorted[i].place.line == sorted[j].place.line;
    };
    // How far the faces of record i are from the direction to or from j.
    const auto deviation = [&sorted](const unsigned int i,
                                     const unsigned int j) {
      return std::abs(sorted[i].record.normal *
                      (sorted[i].record.position - sorted[j].record.position));
    };
    for (unsigned int i = 0; i + 1 < sorted.size(); ++i)
      {
        if (!of_one_line(i, i + 1) ||
            sorted[i].record.vertex != sorted[i + 1].record.vertex)
          continue;
        const bool has_before = i > 0 && of_one_line(i, i - 1);
        if (has_before ? deviation(i, i - 1) > deviation(i + 1, i - 1) :
                         of_one_line(i, i + 2) &&
                           deviation(i, i + 2) < deviation(i + 1, i + 2))
          std::swap(sorted[i], sorted[i + 1]);
      }
  }



  std::vector<WallTraction>
  WallTractions<2>::at_rest(const WallRecords &records) const
  {
    const auto                sorted = collect(records);
    std::vector<Tensor<1, 3>> forces;
    for (const PlacedRecord &placed : sorted)
      forces.push_back(placed.record.impulse / records.time);
    return make_tractions(0., sorted, forces);
  }



  std::vector<WallTraction>
  WallTractions<2>::since(WallImpulses      &last,
                          const double       time,
                          const WallRecords &records) const
  {
    const auto sorted = collect(records);
    last.impulses.resize(sorted.size());

    const double              duration = records.time - last.time;
    std::vector<Tensor<1, 3>> forces;
    for (unsigned int i = 0; i < sorted.size(); ++i)
      {
        const Tensor<1, 3> &impulse = sorted[i].record.impulse;
        forces.push_back(duration > 0. ?
                           (impulse - last.impulses[i]) / duration :
                           Tensor<1, 3>());
        last.impulses[i] = impulse;
      }
    last.time = records.time;
    return make_tractions(time, sorted, forces);
  }



  std::vector<WallTraction>
  WallTractions<2>::make_tractions(
    const double                     time,
    const std::vector<PlacedRecord> &placed,
    const std::vector<Tensor<1, 3>> &forces) const
  {
    std::vector<WallRecord> records;
    for (const PlacedRecord &of_node : placed)
      records.push_back(of_node.record);
    const CornerShares shares(scene.mesh, scene.walls, records);
    const auto         shared = shares.share(forces);

    std::vector<WallTraction> tractions;
    for (unsigned int i = 0; i < placed.size(); ++i)
      {
        PlacedRecord of_node  = placed[i];
        of_node.record.normal = in_space(shares.normal(i));
        tractions.push_back(make_traction(time, of_node, shared[i]));
      }
    return tractions;
  }



  WallTraction
  WallTractions<2>::make_traction(const double        time,
                                  const PlacedRecord &placed,
                                  const Tensor<1, 3> &force) const
  {
    const WallRecord &record = placed.record;
    WallTraction      traction{};
    traction.time           = time;
    traction.record         = record;
    traction.role           = scene.walls[record.wall].role;
    traction.wall_name      = scene.walls[record.wall].name;
    traction.place          = placed.place;
    traction.on_material    = force / record.area;
    traction.janssen_normal = references.janssen_normal(record);
    traction.eurocode_filling =
      references.eurocode(EurocodePressures::Load::filling, record);
    traction.eurocode_discharge =
      references.eurocode(EurocodePressures::Load::discharge, record);
    traction.eurocode_filling_patch =
      references.eurocode_patch(EurocodePressures::Load::filling, record);
    traction.eurocode_discharge_patch =
      references.eurocode_patch(EurocodePressures::Load::discharge, record);
    return traction;
  }



  void
  WallTractions<2>::write(const double                     time,
                          const std::vector<WallTraction> &tractions)
  {
    if (!is_writer)
      return;
    for (const WallTraction &traction : tractions)
      table.add_row(traction);
    table.flush();
    series.write(time, wall_fields(tractions));
  }
} // namespace Sandglass
