#include <sandglass/run/flow_state.h>
#include <sandglass/scene/feed_cells.h>
#include <sandglass/scene/gates.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/scene/mesh_faces.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  struct SmallSilo : StageFixture
  {
    explicit SmallSilo(const CellType cell_type)
    {
      silo.cell_type         = cell_type;
      silo.half_width        = 0.3;
      silo.wall_height       = 0.6;
      silo.outlet_half_width = 0.1;
      silo.fall_region_depth = 0.2;
      silo.element_size      = 0.05;
    }

    FlowTotals
    totals() const
    {
      return stage->view().totals();
    }

    /// Difference between what there is and what there was or has entered,
    /// over the latter.
    double
    mass_error(const double initial_mass) const
    {
      const FlowTotals now = totals();
      const double     all = initial_mass + now.mass_fed;
      return std::abs(mass_of_all(now) - all) / all;
    }

    /// Go on on another mesh with the same cells.
    void
    move_to(const Mesh<2> &mesh)
    {
      auto next_scene = std::make_unique<Scene<2>>(
        mesh, walls, formulation, particles_per_cell, gravity, MPI_COMM_WORLD);
      auto next_flow = make_flow(*next_scene);
      hand_over(*stage, *next_flow, MPI_COMM_WORLD);
      stage.reset(dynamic_cast<Stage *>(next_flow.release()));
      stage->start_wall_records_anew();
      scene = std::move(next_scene);
    }

    void
    run(const double duration)
    {
      const double end = stage->view().clock().time + duration;
      while (stage->view().clock().time < end)
        stage->step();
    }

    SceneParameters silo;
  };

  class Operation : public testing::TestWithParam<CellType>
  {};
} // namespace



// What leaves comes in again: the silo stays full, and no mass is lost or made.
TEST_P(Operation, LevelIsKept)
{
  SmallSilo silo(GetParam());
  silo.feed.kind = FeedKind::level;
  silo.start(make_mesh<2>(silo.silo, MPI_COMM_WORLD));
  const double initial_mass = silo.totals().mass_in_silo;
  for (unsigned int n = 0; n < 10; ++n)
    {
      silo.run(0.1);
      EXPECT_LT(silo.mass_error(initial_mass), 1e-12);
      EXPECT_NEAR(silo.totals().mass_in_silo / initial_mass, 1., 0.05) << n;
    }
  EXPECT_GT(silo.totals().mass_fed, 0.1 * initial_mass);
  EXPECT_NEAR(silo.totals().mass_fed / discharged_mass(silo.totals()), 1., 0.3);

  // Ids of the living are their own.
  std::set<std::uint64_t> ids;
  silo.stage->view().for_each_particle([&](const ParticleRecord &particle) {
    EXPECT_TRUE(ids.insert(particle.id).second) << particle.id;
  });
}



// Rain brings its rate to a particle, and falls as things do.
TEST_P(Operation, RainHasItsRate)
{
  SmallSilo silo(GetParam());
  silo.silo.outlet_is_open = false;
  silo.silo.fill_height    = 0.1;
  silo.silo.wall_height    = 1.;
  silo.feed.kind           = FeedKind::rain;
  silo.feed.rate           = 60.;
  silo.feed.right          = 0.2;
  silo.feed.start          = 0.05;
  silo.feed.end            = 0.35;
  silo.start(make_mesh<2>(silo.silo, MPI_COMM_WORLD));
  const double initial_mass = silo.totals().mass_in_silo;
  const double of_particle  = 1500. * 0.05 * 0.05 / 4.;
  for (unsigned int n = 1; n <= 8; ++n)
    {
      silo.run(0.05);
      EXPECT_LT(silo.mass_error(initial_mass), 1e-12);
      const double time = silo.stage->view().clock().time;
      // The grid is half of the silo.
      EXPECT_NEAR(silo.totals().mass_fed,
                  30. * std::max(0., std::min(time, 0.35) - 0.05),
                  of_particle)
        << time;
    }
  // Velocity after a free fall from where it came in, with 1 m/s
  silo.stage->view().for_each_particle([&](const ParticleRecord &particle) {
    const double height = particle.initial_location[1] - particle.location[1];
    if (particle.initial_location[1] > 0.9 && particle.location[1] > 0.4)
      {
        EXPECT_NEAR(-particle.velocity[1],
                    std::sqrt(1. + 2. * 9.81 * height),
                    0.12 * std::sqrt(1. + 2. * 9.81 * height));
      }
  });
}



// Nothing passes a closed gate, and what is on its way down below one that
// closes goes on falling.
TEST_P(Operation, GateOpensAndCloses)
{
  SmallSilo      silo(GetParam());
  const Mesh<2>  mesh = make_mesh<2>(silo.silo, MPI_COMM_WORLD);
  GateParameters parameters;
  parameters.openings["outlet"] = {0.1, 0., 0.2, 100., 0.5, 100., 0.6, 0.};
  const Gates<2> gates(mesh, parameters);
  auto           closed = gates.closed_at(0.);
  silo.start(gates.close(closed));
  const double initial_mass = silo.totals().mass_in_silo;

  double   at_closure = 0.;
  unsigned n_moves    = 0;
  while (silo.stage->view().clock().time < 1.2)
    {
      const double time = silo.stage->view().clock().time;
      if (const auto now = gates.closed_at(time); now != closed)
        {
          silo.move_to(gates.close(now));
          closed = now;
          ++n_moves;
        }
      silo.stage->step();
      const FlowTotals totals = silo.totals();
      ASSERT_LT(silo.mass_error(initial_mass), 1e-12) << time;
      if (time < 0.1)
        {
          ASSERT_LT(discharged_mass(totals), 1e-12 * initial_mass) << time;
        }
      if (time < 0.65)
        at_closure = discharged_mass(totals);
    }
  EXPECT_EQ(n_moves, 4u); // two faces, open and closed one by one
  EXPECT_GT(at_closure, 0.05 * initial_mass);
  EXPECT_NEAR(discharged_mass(silo.totals()), at_closure, 1e-12 * initial_mass);
  EXPECT_LT(silo.totals().mass_falling, 0.02 * at_closure);
}



// With one outlet closed all comes through the other one.
TEST(SeveralOutlets, AreToldApart)
{
  SmallSilo     silo(CellType::quadrilateral);
  const Mesh<2> mesh = [] {
    // Two silos side by side, with a wall in between.
    Rectangle rectangle;
    rectangle.cell_type = CellType::quadrilateral;
    rectangle.lower     = Point<2>(-0.4, -0.2);
    rectangle.upper     = Point<2>(0.4, 0.6);
    rectangle.n_x       = 8;
    rectangle.n_y       = 8;
    rectangle.left      = BoundaryRole::wall;
    Mesh<2> whole       = rectangle.mesh();
    Mesh<2> result      = whole;
    result.cells.clear();
    result.faces.clear();
    const auto is_outlet = [](const double x) {
      return std::abs(std::abs(x) - 0.25) < 0.1;
    };
    for (auto cell : whole.cells)
      {
        Point<2> middle;
        for (const unsigned int v : cell.vertices)
          middle += whole.vertices[v] / 4.;
        cell.is_filled = middle[1] > 0.;
        if (middle[1] > 0. || is_outlet(middle[0]))
          result.cells.push_back(cell);
      }
    for (const auto &[vertices, cells] : cells_at_faces(result))
      {
        const Point<2> middle(
          (result.vertices[vertices[0]] + result.vertices[vertices[1]]) / 2.);
        const bool is_level = std::abs(result.vertices[vertices[0]][1] -
                                       result.vertices[vertices[1]][1]) < 1e-9;
        if (cells.size() == 1)
          result.faces.push_back(
            {vertices,
             middle[1] < -0.19            ? BoundaryRole::fall_bottom :
             middle[1] < -1e-9            ? BoundaryRole::fall_side :
             is_level && middle[1] < 1e-9 ? BoundaryRole::floor :
             is_level                     ? BoundaryRole::top :
                                            BoundaryRole::wall});
        else if (is_level && std::abs(middle[1]) < 1e-9)
          result.faces.push_back({vertices, BoundaryRole::outlet});
      }
    sort_along_curve(result);
    return result;
  }();
  GateParameters parameters;
  parameters.openings["outlet_1"] = {0., 0.};
  const Gates<2> gates(mesh, parameters);
  silo.start(gates.close(gates.closed_at(0.)));
  silo.run(0.6);
  const FlowTotals totals = silo.totals();
  ASSERT_EQ(totals.mass_by_outlet.size(), 2u);
  EXPECT_EQ(totals.mass_by_outlet[0], 0.);
  EXPECT_GT(totals.mass_by_outlet[1], 1.);
  EXPECT_GT(totals.mass_removed, 1.);
  EXPECT_NEAR(totals.mass_by_outlet[1],
              discharged_mass(totals),
              1e-12 * mass_of_all(totals));
}



INSTANTIATE_TEST_SUITE_P(Cells,
                         Operation,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
