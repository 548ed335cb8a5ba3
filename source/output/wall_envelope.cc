#include <sandglass/output/wall_envelope.h>

namespace Sandglass
{
  void
  WallEnvelope::add(std::vector<WallTraction> &tractions,
                    const double               mass_share)
  {
    ranges.resize(tractions.size());
    for (unsigned int i = 0; i < tractions.size(); ++i)
      {
        WallTraction &traction = tractions[i];
        NormalRange  &range    = ranges[i];
        const double  normal   = traction.normal();
        if (traction.time == 0.)
          {
            range.filling            = normal;
            range.filling_tangential = traction.tangential();
          }
        else
          {
            if (!(normal <= range.largest))
              {
                range.largest            = normal;
                range.largest_time       = traction.time;
                range.largest_tangential = traction.tangential();
              }
            if (mass_share >= full_share && !(normal >= range.smallest))
              {
                range.smallest      = normal;
                range.smallest_time = traction.time;
              }
          }
        traction.range = range;
      }
  }



  const std::vector<Column<WallTraction>> wall_envelope_table = {
    {"wall",
     "",
     [](const WallTraction &t) { return std::string(t.wall_name); },
     "the wall's name"},
    {"side",
     "",
     [](const WallTraction &t) { return std::string(name_of(t.place.side)); },
     "as in wall_traction.csv"},
    {"arc_length_m",
     "m",
     [](const WallTraction &t) { return t.place.arc_length; },
     "likewise"},
    {"x_m",
     "m",
     [](const WallTraction &t) { return t.record.position[0]; },
     "of the node"},
    {"y_m",
     "m",
     [](const WallTraction &t) { return t.record.position[1]; },
     "of the node, above the outlet level"},
    {"filling_normal_Pa",
     "Pa",
     [](const WallTraction &t) { return t.range.filling; },
     "at rest; `nan` without a state at rest"},
    {"filling_tangential_Pa",
     "Pa",
     [](const WallTraction &t) { return t.range.filling_tangential; },
     "likewise, along the wall"},
    {"largest_normal_Pa",
     "Pa",
     [](const WallTraction &t) { return t.range.largest; },
     "the largest in discharge, of the means over `Output/Interval`; `nan` "
     "before the first of them"},
    {"largest_time_s",
     "s",
     [](const WallTraction &t) { return t.range.largest_time; },
     "when that interval ended"},
    {"largest_tangential_Pa",
     "Pa",
     [](const WallTraction &t) { return t.range.largest_tangential; },
     "along the wall, in the same interval"},
    {"largest_over_filling",
     "1",
     [](const WallTraction &t) { return t.range.ratio(); },
     "`largest_normal_Pa` over `filling_normal_Pa`; `nan` where the wall bears "
     "nothing at rest"},
    {"smallest_normal_Pa",
     "Pa",
     [](const WallTraction &t) { return t.range.smallest; },
     "the smallest in discharge, as long as three quarters of the initial mass "
     "are in the silo"},
    {"smallest_time_s",
     "s",
     [](const WallTraction &t) { return t.range.smallest_time; },
     "when that interval ended"},
    {"en_1991_4_filling_normal_Pa",
     "Pa",
     [](const WallTraction &t) { return t.eurocode_filling.normal; },
     "symmetrical filling pressure of EN 1991-4, see "
     "[theory.md](theory.md#reference-pressures); `nan` where it does not "
     "apply"},
    {"en_1991_4_filling_patch_Pa",
     "Pa",
     [](const WallTraction &t) { return t.eurocode_filling_patch; },
     "what the patch load adds to that where it acts"},
    {"en_1991_4_discharge_normal_Pa",
     "Pa",
     [](const WallTraction &t) { return t.eurocode_discharge.normal; },
     "symmetrical discharge pressure of EN 1991-4"},
    {"en_1991_4_discharge_patch_Pa",
     "Pa",
     [](const WallTraction &t) { return t.eurocode_discharge_patch; },
     "what the patch load adds to that where it acts"}};



  std::string
  wall_envelope_text(const std::vector<WallTraction> &tractions,
                     const bool                       outlet_opens)
  {
    std::vector<WallTraction> rows;
    for (const WallTraction &traction : tractions)
      if (!outlet_opens || traction.role != BoundaryRole::outlet)
        rows.push_back(traction);
    return csv_text(wall_envelope_table, rows);
  }
} // namespace Sandglass
