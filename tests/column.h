#ifndef sandglass_tests_column_h
#define sandglass_tests_column_h

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "rest.h"
#include "stage_fixture.h"

/**
 * A column of dry sand, half its plane section or an axisymmetric one, behind
 * a gate that vanishes. The gate is an inner edge with the role of an outlet:
 * a wall in the static stage, nothing in the particle stage.
 */
class SandColumn
{
public:
  static constexpr double width = 0.1; ///< half width or radius, m

  /// With `n_columns` cells in the half width, and a floor that has room for a
  /// deposit that spreads by `run_out` half widths.
  SandColumn(const Sandglass::Formulation formulation,
             const Sandglass::CellType    cell_type,
             const double                 aspect_ratio,
             const double                 run_out,
             const unsigned int           n_columns)
  {
    const double h      = width / n_columns;
    const double height = aspect_ratio * width;
    fixture.formulation = formulation;
    // A floor as rough as the sand: the material's 25 degrees on the cone are
    // 30 degrees of Coulomb friction in plane flow.
    fixture.walls.friction_angle = 30.;
    fixture.parameters.end_time  = 8. * std::sqrt(height / 9.81);
    Rectangle rectangle;
    rectangle.cell_type = cell_type;
    rectangle.n_x = static_cast<unsigned int>((2. + 1.5 * run_out) * n_columns);
    rectangle.n_y = static_cast<unsigned int>(std::round(1.2 * height / h)) + 2;
    rectangle.upper = dealii::Point<2>(rectangle.n_x * h, rectangle.n_y * h);
    rectangle.is_filled = [height](const dealii::Point<2> &center) {
      return center[0] < width && center[1] < height;
    };
    Sandglass::Mesh<2> mesh = rectangle.mesh();
    add_gate(mesh, height);
    fixture.start(mesh);
    start_from_rest(fixture);
  }

  void
  collapse()
  {
    while (!fixture.stage->is_finished())
      fixture.stage->step();
  }

  /// Where the deposit ends without the given share of its mass, in m.
  double
  front(const double share) const
  {
    std::vector<std::pair<double, double>> masses;
    double                                 mass = 0.;
    fixture.for_each_particle([&](auto, const auto &position, auto state) {
      masses.emplace_back(position[0], state[StageLayout::mass]);
      mass += state[StageLayout::mass];
    });
    std::sort(masses.begin(), masses.end());
    double beyond = 0.;
    while (beyond + masses.back().second < share * mass)
      {
        beyond += masses.back().second;
        masses.pop_back();
      }
    return masses.back().first;
  }

  /// Mean of x over the mass, in m.
  double
  mean_distance() const
  {
    double mass = 0., moment = 0.;
    fixture.for_each_particle([&](auto, const auto &position, auto state) {
      mass += state[StageLayout::mass];
      moment += position[0] * state[StageLayout::mass];
    });
    return moment / mass;
  }

  double
  summit() const
  {
    double highest = 0.;
    fixture.for_each_particle([&](auto, const auto &position, auto) {
      highest = std::max(highest, position[1]);
    });
    return highest;
  }

  StageFixture fixture;

private:
  /// Name the gate, and the column's free surface, which the static stage
  /// asks for.
  static void
  add_gate(Sandglass::Mesh<2> &mesh, const double height)
  {
    add_edges(mesh, 0, width, height, Sandglass::BoundaryRole::outlet);
    add_edges(mesh, 1, height, width, Sandglass::BoundaryRole::top);
  }

  /// Name the edges on the line x_d = value up to `end` along it.
  static void
  add_edges(Sandglass::Mesh<2>           &mesh,
            const unsigned int            d,
            const double                  value,
            const double                  end,
            const Sandglass::BoundaryRole role)
  {
    std::vector<std::pair<double, unsigned int>> vertices;
    for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
      if (std::abs(mesh.vertices[v][d] - value) < 1e-9 &&
          mesh.vertices[v][1 - d] < end + 1e-9)
        vertices.emplace_back(mesh.vertices[v][1 - d], v);
    std::sort(vertices.begin(), vertices.end());
    for (unsigned int i = 1; i < vertices.size(); ++i)
      mesh.faces.push_back(
        {{{vertices[i - 1].second, vertices[i].second}}, role});
  }
};

#endif
