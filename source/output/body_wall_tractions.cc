#include <deal.II/base/mpi.h>

#include <sandglass/output/body_wall_tractions.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace Sandglass
{
  WallTractions<3>::WallTractions(const OutputParameters   &parameters,
                                  const Scene<3>           &scene,
                                  const MaterialParameters &material)
    : scene(scene)
    , is_writer(Utilities::MPI::this_mpi_process(scene.communicator) == 0)
    , references(parameters, scene, material)
    , parts(scene)
    , table(parameters.directory + "/wall_traction.csv",
            wall_band_table,
            WallBand())
    , series(parameters.directory, "walls", MPI_COMM_SELF)
  {}



  void
  WallTractions<3>::open()
  {
    if (!is_writer)
      return;
    table.open();
    series.open();
  }



  void
  WallTractions<3>::refuse_other(const std::string &directory) const
  {
    if (is_writer)
      table.refuse_other(directory);
  }



  std::vector<WallRecord>
  WallTractions<3>::collect(const WallRecords &records) const
  {
    std::vector<WallRecord> result;
    for (const auto &of_rank :
         Utilities::MPI::gather(scene.communicator, records.records))
      for (const WallRecord &record : of_rank)
        if (record.wall != no_wall)
          result.push_back(record);

    const auto key = [this](const WallRecord &record) {
      return std::make_tuple(scene.walls[record.wall].role,
                             record.wall,
                             record.vertex,
                             record.normal[0],
                             record.normal[1],
                             record.normal[2]);
    };
    std::sort(result.begin(),
              result.end(),
              [&key](const auto &a, const auto &b) { return key(a) < key(b); });
    return result;
  }



  std::vector<WallTraction>
  WallTractions<3>::at_rest(const WallRecords &records) const
  {
    std::vector<WallTraction> tractions;
    for (const WallRecord &record : collect(records))
      tractions.push_back(
        make_traction(0., record, record.impulse / records.time));
    return tractions;
  }



  std::vector<WallTraction>
  WallTractions<3>::since(WallImpulses      &last,
                          const double       time,
                          const WallRecords &records) const
  {
    const auto sorted = collect(records);
    last.impulses.resize(sorted.size());

    const double              duration = records.time - last.time;
    std::vector<WallTraction> tractions;
    for (unsigned int i = 0; i < sorted.size(); ++i)
      {
        const Tensor<1, 3> &impulse = sorted[i].impulse;
        tractions.push_back(
          make_traction(time,
                        sorted[i],
                        duration > 0. ?
                          (impulse - last.impulses[i]) / duration :
                          Tensor<1, 3>()));
        last.impulses[i] = impulse;
      }
    last.time = records.time;
    return tractions;
  }



  WallTraction
  WallTractions<3>::make_traction(const double        time,
                                  const WallRecord   &record,
                                  const Tensor<1, 3> &force) const
  {
    const unsigned int part = parts.part_of(record);
    WallTraction       traction{};
    traction.time           = time;
    traction.record         = record;
    traction.role           = scene.walls[record.wall].role;
    traction.wall_name      = scene.walls[record.wall].name;
    traction.place          = {part,
                               parts.arc_length(part, record.position),
                               WallLines::Side::middle};
    traction.on_material    = force / record.area;
    traction.janssen_normal = references.janssen_normal(record);
    traction.eurocode_filling =
      references.eurocode(EurocodePressures::Load::filling, record);
    traction.eurocode_discharge =
      references.eurocode(EurocodePressures::Load::discharge, record);
    traction.eurocode_filling_patch   = NormalRange::nothing;
    traction.eurocode_discharge_patch = NormalRange::nothing;
    return traction;
  }



  VtuPiece
  WallTractions<3>::make_picture(
    const std::vector<WallTraction> &tractions) const
  {
    // A face has of each of its nodes the record of its own wall whose normal
    // is nearest to its own.
    std::map<std::pair<WallId, unsigned int>, std::vector<unsigned int>>
      records_at;
    for (unsigned int i = 0; i < tractions.size(); ++i)
      records_at[{tractions[i].record.wall, tractions[i].record.vertex}]
        .push_back(i);

    VtuPiece           piece;
    const unsigned int n  = scene.mesh.vertices_per_face();
    piece.points_per_cell = n;
    piece.cell_dimension  = 2;
    for (const auto &face : scene.mesh.faces)
      {
        const WallId wall = boundary_part(scene.walls, face.boundary_id()).wall;
        const auto  &x    = scene.mesh.vertices;
        const Tensor<1, 3> normal =
          cross_product_3d(x[face.vertices[1]] - x[face.vertices[0]],
                           x[face.vertices[2]] - x[face.vertices[0]]);
        std::vector<std::int32_t> corners;
        for (unsigned int v = 0; v < n; ++v)
          if (const auto records = records_at.find({wall, face.vertices[v]});
              records != records_at.end())
            corners.push_back(*std::max_element(
              records->second.begin(),
              records->second.end(),
              [&](const unsigned int a, const unsigned int b) {
                return tractions[a].record.normal * normal <
                       tractions[b].record.normal * normal;
              }));
        if (corners.size() == n)
          piece.cells.insert(piece.cells.end(), corners.begin(), corners.end());
      }
    add_wall_points(piece, tractions);
    return piece;
  }



  void
  WallTractions<3>::write(const double                     time,
                          const std::vector<WallTraction> &tractions)
  {
    if (!is_writer)
      return;
    for (const WallBand &band : make_bands(tractions))
      table.add_row(band);
    table.flush();
    series.write(time, make_picture(tractions));
  }
} // namespace Sandglass
