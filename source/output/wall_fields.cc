#include <sandglass/output/wall_tractions.h>

#include <utility>

namespace Sandglass
{
  namespace
  {
    /// One number at each node of the walls.
    struct ScalarField
    {
      const char *name;
      double (*value)(const WallTraction &traction);
    };

    constexpr ScalarField scalar_fields[] = {
      {"normal traction", [](const WallTraction &t) { return t.normal; }},
      {"tangential traction",
       [](const WallTraction &t) { return t.tangential; }},
      {"Janssen normal traction",
       [](const WallTraction &t) { return t.janssen_normal; }},
      {"side",
       [](const WallTraction &t) { return static_cast<double>(t.place.side); }},
      {"EN 1991-4 filling normal traction",
       [](const WallTraction &t) { return t.eurocode_filling.normal; }},
      {"EN 1991-4 filling tangential traction",
       [](const WallTraction &t) { return t.eurocode_filling.tangential; }},
      {"EN 1991-4 discharge normal traction",
       [](const WallTraction &t) { return t.eurocode_discharge.normal; }},
      {"EN 1991-4 discharge tangential traction",
       [](const WallTraction &t) { return t.eurocode_discharge.tangential; }}};



    /// Of wall on material, in Pa.
    Tensor<1, dim>
    traction_on_material(const WallTraction &traction)
    {
      return -traction.normal * traction.force.normal +
             traction.tangential * wall_tangent(traction.force.normal);
    }
  } // namespace



  VtuPiece
  wall_fields(const std::vector<WallTraction> &tractions)
  {
    VtuPiece piece;
    piece.points_per_cell = 2;
    std::vector<float> on_material;
    for (unsigned int i = 0; i < tractions.size(); ++i)
      {
        const WallTraction &traction = tractions[i];
        const Point<dim>   &position = traction.force.position;
        piece.points.insert(piece.points.end(), {position[0], position[1], 0.});
        const Tensor<1, dim> vector = traction_on_material(traction);
        for (const double component : {vector[0], vector[1], 0.})
          on_material.push_back(component);
        if (i > 0 && traction.force.role == tractions[i - 1].force.role &&
            traction.place.line == tractions[i - 1].place.line)
          for (const auto end : {i - 1, i})
            piece.cells.push_back(end);
      }

    for (const ScalarField &field : scalar_fields)
      {
        std::vector<float> values;
        for (const WallTraction &traction : tractions)
          values.push_back(field.value(traction));
        piece.point_fields.push_back({field.name, 1, std::move(values), {}});
      }
    piece.point_fields.insert(
      piece.point_fields.begin() + 2,
      {"traction on material", 3, std::move(on_material), {}});
    return piece;
  }
} // namespace Sandglass
