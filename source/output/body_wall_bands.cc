// The bands of wall_traction.csv in three dimensions.

#include <sandglass/output/body_wall_tractions.h>

#include <map>
#include <utility>

namespace Sandglass
{
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
