#include <sandglass/output/section_wall_tractions.h>

#include <utility>

namespace Sandglass
{
  const std::vector<WallQuantity> wall_table = {
    {"time_s",
     nullptr,
     "s",
     [](const WallTraction &t) { return t.time; },
     "simulated time"},
    {"wall",
     nullptr,
     "",
     [](const WallTraction &t) { return std::string(t.wall_name); },
     "the wall's name: `wall`, `floor`, `hopper`, `outlet` where it is "
     "closed, or a mesh file's physical group"},
    {"arc_length_m",
     nullptr,
     "m",
     [](const WallTraction &t) { return t.place.arc_length; },
     "along the wall, from its end next to the middle of the outlet"},
    {"x_m",
     nullptr,
     "m",
     [](const WallTraction &t) { return t.record.position[0]; },
     "of the node"},
    {"y_m",
     nullptr,
     "m",
     [](const WallTraction &t) { return t.record.position[1]; },
     "of the node, above the outlet level"},
    {"normal_Pa",
     "normal traction",
     "Pa",
     [](const WallTraction &t) { return t.normal(); },
     "positive in compression. At t = 0 the static stage's; later the mean "
     "over the time since the row before, because the forces at single nodes "
     "and steps are noisy. Forces are recorded as impulses: traction times the "
     "node's share of the wall, summed over all walls, floors and the axis, is "
     "the weight less the change of momentum per time, to rounding. Where walls "
     "meet, see [theory.md](theory.md#tractions-at-corners)"},
    {"tangential_Pa",
     "tangential traction",
     "Pa",
     [](const WallTraction &t) { return t.tangential(); },
     "likewise; positive where the wall pushes the material up (on the floor: "
     "to the right, which is outwards on the right side)"},
    {nullptr,
     "traction on material",
     "Pa",
     [](const WallTraction &t) { return t.on_material; },
     "both as a vector"},
    {"janssen_normal_Pa",
     "Janssen normal traction",
     "Pa",
     [](const WallTraction &t) { return t.janssen_normal; },
     "Janssen's pressure, see [theory.md](theory.md#reference-pressures); `nan` "
     "where it does not apply"},
    {"side",
     nullptr,
     "",
     [](const WallTraction &t) { return std::string(name_of(t.place.side)); },
     "`left` or `right` of the outlet's middle, `middle` for a line on both "
     "sides (a closed outlet); half a silo is its right side"},
    {nullptr,
     "side",
     "1",
     [](const WallTraction &t) { return static_cast<double>(t.place.side); },
     "-1 left of the outlet's middle, 1 right of it, 0 for a line on both sides"},
    {"en_1991_4_filling_normal_Pa",
     "EN 1991-4 filling normal traction",
     "Pa",
     [](const WallTraction &t) { return t.eurocode_filling.normal; },
     "symmetrical filling pressure of EN 1991-4, likewise"},
    {"en_1991_4_filling_tangential_Pa",
     "EN 1991-4 filling tangential traction",
     "Pa",
     [](const WallTraction &t) { return t.eurocode_filling.tangential; },
     "along the wall"},
    {"en_1991_4_discharge_normal_Pa",
     "EN 1991-4 discharge normal traction",
     "Pa",
     [](const WallTraction &t) { return t.eurocode_discharge.normal; },
     "symmetrical discharge pressure of EN 1991-4"},
    {"en_1991_4_discharge_tangential_Pa",
     "EN 1991-4 discharge tangential traction",
     "Pa",
     [](const WallTraction &t) { return t.eurocode_discharge.tangential; },
     "along the wall"},
    {nullptr,
     "largest normal traction",
     "Pa",
     [](const WallTraction &t) { return t.range.largest; },
     "in discharge so far, as in `wall_envelope.csv`"},
    {nullptr,
     "smallest normal traction",
     "Pa",
     [](const WallTraction &t) { return t.range.smallest; },
     "likewise, of a full silo"},
    {nullptr,
     "largest over filling normal traction",
     "1",
     [](const WallTraction &t) { return t.range.ratio(); },
     "likewise"},
    {nullptr,
     "EN 1991-4 filling patch",
     "Pa",
     [](const WallTraction &t) { return t.eurocode_filling_patch; },
     "what a patch load adds to the filling pressure"},
    {nullptr,
     "EN 1991-4 discharge patch",
     "Pa",
     [](const WallTraction &t) { return t.eurocode_discharge_patch; },
     "what a patch load adds to the discharge pressure"}};



  std::vector<Column<WallTraction>>
  wall_columns()
  {
    std::vector<Column<WallTraction>> columns;
    for (const WallQuantity &quantity : wall_table)
      if (quantity.column != nullptr)
        std::visit(
          [&](const auto value) {
            using Function = std::decay_t<decltype(value)>;
            if constexpr (FieldNumbers<Function>::n == 1)
              columns.push_back(
                {quantity.column, quantity.unit, value, quantity.meaning});
            else
              Assert(false, ExcMessage("A column has one component."));
          },
          quantity.value);
    return columns;
  }



  namespace
  {
    void
    append(std::vector<float> &values, const double value)
    {
      values.push_back(value);
    }

    void
    append(std::vector<float> &values, const Tensor<1, 3> &vector)
    {
      for (unsigned int d = 0; d < 3; ++d)
        values.push_back(vector[d]);
    }

    void
    append(std::vector<float> &, const std::string &)
    {
      Assert(false, ExcMessage("A field has numbers."));
    }



    VtuPiece::Field
    make_field(const WallQuantity              &quantity,
               const std::vector<WallTraction> &tractions)
    {
      return std::visit(
        [&](const auto value) -> VtuPiece::Field {
          std::vector<float> values;
          for (const WallTraction &traction : tractions)
            append(values, value(traction));
          return {quantity.field,
                  FieldNumbers<std::decay_t<decltype(value)>>::n,
                  std::move(values),
                  {}};
        },
        quantity.value);
    }
  } // namespace



  void
  add_wall_points(VtuPiece &piece, const std::vector<WallTraction> &tractions)
  {
    for (const WallTraction &traction : tractions)
      for (unsigned int d = 0; d < 3; ++d)
        piece.points.push_back(traction.record.position[d]);
    for (const WallQuantity &quantity : wall_table)
      if (quantity.field != nullptr)
        piece.point_fields.push_back(make_field(quantity, tractions));
  }



  VtuPiece
  wall_fields(const std::vector<WallTraction> &tractions)
  {
    VtuPiece piece;
    piece.points_per_cell = 2;
    piece.cell_dimension  = 1;
    for (unsigned int i = 1; i < tractions.size(); ++i)
      {
        const WallTraction &traction = tractions[i];
        // At a bend a line goes on from the node's second record.
        if (traction.record.wall == tractions[i - 1].record.wall &&
            traction.record.vertex != tractions[i - 1].record.vertex &&
            traction.place.line == tractions[i - 1].place.line)
          for (const auto end : {i - 1, i})
            piece.cells.push_back(end);
      }
    add_wall_points(piece, tractions);
    return piece;
  }
} // namespace Sandglass
