#include <deal.II/base/mpi.h>

#include <sandglass/output/body_wall_tractions.h>

#include <algorithm>
#include <cmath>
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



  namespace
  {
    /// Sums over the nodes of a band, weighted by their areas.
    struct BandSums
    {
      WallBand band{};

      void
      add(const WallTraction &traction,
          const Tensor<1, 3> &tangent,
          const double        distance)
      {
        const WallRecord &record = traction.record;
        if (band.area == 0. || traction.normal() > band.largest_normal)
          {
            band.largest_normal = traction.normal();
            band.largest_at     = record.position;
          }
        band.area += record.area;
        band.arc_length += record.area * traction.place.arc_length;
        band.distance += record.area * distance;
        band.height += record.area * record.position[1];
        band.normal += record.area * traction.normal();
        band.tangential += record.area * (traction.on_material * tangent);
        band.janssen_normal += record.area * traction.janssen_normal;
        const auto add_pressure = [&record](WallPressure       &sum,
                                            const WallPressure &pressure) {
          sum.normal += record.area * pressure.normal;
          sum.tangential += record.area * pressure.tangential;
        };
        add_pressure(band.eurocode_filling, traction.eurocode_filling);
        add_pressure(band.eurocode_discharge, traction.eurocode_discharge);
      }

      WallBand
      mean() const
      {
        WallBand result = band;
        for (double *sum : {&result.arc_length,
                            &result.distance,
                            &result.height,
                            &result.normal,
                            &result.tangential,
                            &result.janssen_normal,
                            &result.eurocode_filling.normal,
                            &result.eurocode_filling.tangential,
                            &result.eurocode_discharge.normal,
                            &result.eurocode_discharge.tangential})
          *sum /= band.area;
        return result;
      }
    };
  } // namespace



  std::vector<WallBand>
  WallTractions<3>::make_bands(const std::vector<WallTraction> &tractions) const
  {
    std::map<std::pair<unsigned int, unsigned int>, BandSums> sums;
    for (const WallTraction &traction : tractions)
      {
        const unsigned int part = traction.place.line;
        const Point<3>    &at   = traction.record.position;
        BandSums          &band = sums[{part, parts.band_of(part, at)}];
        if (band.band.area == 0.)
          {
            band.band.eurocode_filling =
              band.band.eurocode_discharge = {0., 0.};
            band.band.time                 = traction.time;
            band.band.wall                 = traction.wall_name;
            band.band.side                 = parts.all()[part].side;
          }
        band.add(traction,
                 parts.tangent(traction.record),
                 parts.distance_from_middle(at));
      }
    std::vector<WallBand> bands;
    for (const auto &[place, band] : sums)
      bands.push_back(band.mean());
    return bands;
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



  const std::vector<Column<WallBand>> wall_band_table = {
    {"time_s", "s", [](const WallBand &b) { return b.time; }, "simulated time"},
    {"wall",
     "",
     [](const WallBand &b) { return b.wall; },
     "the wall's name: `wall`, `floor`, `hopper`, `outlet` where it is closed, "
     "or a mesh file's physical group"},
    {"arc_length_m",
     "m",
     [](const WallBand &b) { return b.arc_length; },
     "along the wall, from where it begins next to the outlet: up walls and "
     "hoppers, outwards on floors; mean of the band"},
    {"x_m",
     "m",
     [](const WallBand &b) { return b.distance; },
     "horizontal distance from the outlet's middle (of a slot, from its middle "
     "line); mean of the band"},
    {"y_m",
     "m",
     [](const WallBand &b) { return b.height; },
     "above the outlet level; mean of the band"},
    {"normal_Pa",
     "Pa",
     [](const WallBand &b) { return b.normal; },
     "force over area of the band, positive in compression. At t = 0 the static "
     "stage's; later the mean over the time since the rows before"},
    {"tangential_Pa",
     "Pa",
     [](const WallBand &b) { return b.tangential; },
     "likewise; positive where the wall pushes the material up (on the floor: "
     "outwards)"},
    {"janssen_normal_Pa",
     "Pa",
     [](const WallBand &b) { return b.janssen_normal; },
     "Janssen's pressure with the hydraulic radius of the cross section, see "
     "[theory.md](theory.md#reference-pressures); `nan` where it does not "
     "apply"},
    {"side",
     "",
     [](const WallBand &b) { return b.side; },
     "which side of the wall: `right`, `left`, `front` or `back` (it faces x, "
     "-x, z or -z), or `around`"},
    {"en_1991_4_filling_normal_Pa",
     "Pa",
     [](const WallBand &b) { return b.eurocode_filling.normal; },
     "symmetrical filling pressure of EN 1991-4, likewise"},
    {"en_1991_4_filling_tangential_Pa",
     "Pa",
     [](const WallBand &b) { return b.eurocode_filling.tangential; },
     "along the wall"},
    {"en_1991_4_discharge_normal_Pa",
     "Pa",
     [](const WallBand &b) { return b.eurocode_discharge.normal; },
     "symmetrical discharge pressure of EN 1991-4"},
    {"en_1991_4_discharge_tangential_Pa",
     "Pa",
     [](const WallBand &b) { return b.eurocode_discharge.tangential; },
     "along the wall"},
    {"area_m2",
     "m^2",
     [](const WallBand &b) { return b.area; },
     "of the band, as far as the grid goes: of half or a quarter of the silo "
     "where symmetry planes end it"},
    {"largest_normal_Pa",
     "Pa",
     [](const WallBand &b) { return b.largest_normal; },
     "largest normal traction of the band's nodes, at the place that follows"},
    {"largest_x_m",
     "m",
     [](const WallBand &b) { return b.largest_at[0]; },
     "x"},
    {"largest_y_m",
     "m",
     [](const WallBand &b) { return b.largest_at[1]; },
     "y"},
    {"largest_z_m",
     "m",
     [](const WallBand &b) { return b.largest_at[2]; },
     "z"}};
} // namespace Sandglass
