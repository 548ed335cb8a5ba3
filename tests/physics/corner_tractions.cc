#include <sandglass/output/section_wall_tractions.h>
#include <sandglass/run/static_to_particles.h>
#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "rest.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  enum class Bottom
  {
    flat,
    hopper,
    /// A hopper that is steeper below than above.
    steepening_hopper
  };

  /// Pull the hopper's wall in at half of its height, and the material with it.
  void
  bend_hopper(Mesh<2> &mesh, const SceneParameters &silo)
  {
    const auto wall_at = [&silo](const double y) {
      return silo.outlet_half_width +
             std::clamp(y / silo.hopper_height, 0., 1.) *
               (silo.half_width - silo.outlet_half_width);
    };
    // At one of its nodes.
    double kink = 0.;
    for (const auto &edge : mesh.faces)
      if (edge.role == BoundaryRole::hopper)
        for (const unsigned int vertex : edge.vertices)
          {
            const double y      = mesh.vertices[vertex][1];
            const double middle = silo.hopper_height / 2.;
            if (std::abs(y - middle) < std::abs(kink - middle))
              kink = y;
          }
    for (Point<2> &vertex : mesh.vertices)
      {
        const double y     = vertex[1];
        const double share = std::max(0.,
                                      std::min(y / kink,
                                               (silo.hopper_height - y) /
                                                 (silo.hopper_height - kink)));
        vertex[0] *= 1. - 0.15 * share / wall_at(y);
      }
  }



  /// A silo at rest, and when it has just begun to flow.
  class CornerTractions
    : public testing::TestWithParam<std::tuple<CellType, Formulation, Bottom>>
  {
  protected:
    CornerTractions()
    {
      const Bottom bottom = std::get<2>(GetParam());
      silo.cell_type      = std::get<0>(GetParam());
      silo.hopper_height  = bottom == Bottom::flat ? 0. : 1.6;
      silo.wall_height    = 1.7;
      silo.element_size   = 0.08;
      fixture.formulation = std::get<1>(GetParam());
      Mesh<2> mesh        = mesh_silo<2>(silo);
      if (bottom == Bottom::steepening_hopper)
        bend_hopper(mesh, silo);
      fixture.start(mesh);
    }

    /// Where several rows belong to one node, each has to be what the next two
    /// rows of its wall let expect. Prints them, for
    /// doc/studies/verification.py.
    void
    expect_own_tractions(const std::string               &when,
                         const WallRecords               &recorded,
                         const std::vector<WallTraction> &tractions)
    {
      std::map<unsigned int, std::vector<unsigned int>> rows_at;
      for (unsigned int i = 0; i < tractions.size(); ++i)
        rows_at[tractions[i].record.vertex].push_back(i);
      unsigned int n_corners = 0;
      for (const auto &[vertex, rows] : rows_at)
        if (rows.size() > 1)
          {
            ++n_corners;
            for (const unsigned int row : rows)
              expect_continuation(when, recorded, tractions, row);
          }
      EXPECT_GE(n_corners,
                std::get<2>(GetParam()) == Bottom::steepening_hopper ? 2u : 1u);
    }

    StageFixture     fixture;
    OutputParameters output;
    SceneParameters  silo;

  private:
    static bool
    belongs_to(const WallTraction &row, const WallTraction &other)
    {
      return row.record.wall == other.record.wall &&
             row.place.line == other.place.line &&
             row.record.normal * other.record.normal > 1. - 1e-6;
    }

    /// In Pa, what the corner's own record would give.
    static double
    recorded_pressure(const WallRecords &recorded, const WallTraction &row)
    {
      for (const WallRecord &record : recorded.records)
        if (record.vertex == row.record.vertex &&
            record.wall == row.record.wall &&
            record.normal * row.record.normal > 1. - 1e-6)
          return -(record.impulse * record.normal) /
                 (recorded.time * record.area);
      return 0.;
    }

    void
    expect_continuation(const std::string               &when,
                        const WallRecords               &recorded,
                        const std::vector<WallTraction> &tractions,
                        const unsigned int               row)
    {
      const WallTraction &corner = tractions[row];
      const int           to_next =
        row + 1 < tractions.size() && belongs_to(corner, tractions[row + 1]) ?
                    1 :
                    -1;
      const WallTraction &next = tractions[row + to_next];
      const WallTraction &far  = tractions[row + 2 * to_next];
      ASSERT_TRUE(belongs_to(corner, next) && belongs_to(corner, far));
      const double s      = corner.place.arc_length;
      const double s_next = next.place.arc_length;
      const double s_far  = far.place.arc_length;
      const auto   expected =
        next.on_material +
        (s - s_next) / (s_far - s_next) * (far.on_material - next.on_material);
      const double difference =
        (corner.on_material - expected).norm() / expected.norm();
      const double y = corner.record.position[1];
      std::cout << when << ", " << corner.wall_name << ' '
                << (next.record.position[1] > y + 1e-9 ? "upwards" :
                    next.record.position[1] < y - 1e-9 ? "downwards" :
                                                         "sideways")
                << " from y = " << y << ": normal " << corner.normal()
                << " Pa, continued " << -(expected * corner.record.normal)
                << " Pa, difference " << difference << ", recorded "
                << recorded_pressure(recorded, corner) << " Pa" << std::endl;
      EXPECT_LT(difference, 0.05)
        << corner.wall_name << " at (" << corner.record.position << ")";
    }
  };
} // namespace



TEST_P(CornerTractions, ContinueThoseBesideThem)
{
  StaticStageParameters parameters;
  std::ostringstream    log_text;
  ConditionalOStream    log(log_text);
  StaticStage<2>        at_rest(
    *fixture.scene, fixture.material, fixture.walls, parameters, log);
  const StaticState<2> state = at_rest.run();
  WallTractions<2>     observer(output, *fixture.scene, fixture.material);
  const WallRecords    at_first = at_rest.view().wall_records();
  expect_own_tractions("at rest", at_first, observer.at_rest(at_first));

  carry_to_particles(state, *fixture.scene, *fixture.stage, false);
  const FlowView &view = fixture.stage->view();
  while (view.clock().time < 0.2)
    fixture.stage->step();
  const WallRecords before = view.wall_records();
  observer.since_last(view.clock().time, before);
  while (view.clock().time < 0.3)
    fixture.stage->step();
  const WallRecords now   = view.wall_records();
  WallRecords       since = now;
  since.time -= before.time;
  for (unsigned int i = 0; i < since.records.size(); ++i)
    since.records[i].impulse -= before.records[i].impulse;
  expect_own_tractions("in flow",
                       since,
                       observer.since_last(view.clock().time, now));
}



INSTANTIATE_TEST_SUITE_P(
  Silos,
  CornerTractions,
  testing::Combine(
    testing::Values(CellType::triangle, CellType::quadrilateral),
    testing::Values(Formulation::plane_strain, Formulation::axisymmetric),
    testing::Values(Bottom::flat, Bottom::hopper, Bottom::steepening_hopper)));
