#include <sandglass/base/exceptions.h>
#include <sandglass/scene/headroom.h>
#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mesh_area.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// Length of the boundary of this role above a height, in m.
  double
  length_above(const Mesh<2> &mesh, const BoundaryRole role, const double y)
  {
    double result = 0.;
    for (const auto &face : mesh.faces)
      {
        const auto &a = mesh.vertices[face.vertices[0]];
        const auto &b = mesh.vertices[face.vertices[1]];
        if (face.role == role && std::min(a[1], b[1]) > y)
          result += a.distance(b);
      }
    return result;
  }

  class Headroom : public testing::TestWithParam<CellType>
  {
  protected:
    Headroom()
    {
      silo.half_width        = 0.5;
      silo.wall_height       = 1.;
      silo.outlet_half_width = 0.2;
      silo.element_size      = 0.1;
      silo.cell_type         = GetParam();
    }

    Mesh<2>
    mesh() const
    {
      return make_mesh<2>(silo, MPI_COMM_SELF, nullptr);
    }

    ClearedParameters cleared;
    SceneParameters   silo;
  };
} // namespace



TEST_P(Headroom, ClosesTheSiloAboveTheMaterial)
{
  const Mesh<2> without = mesh();
  silo.headroom         = 0.25;
  const Mesh<2>    with = mesh();
  constexpr double top  = 0.999;

  EXPECT_NEAR(area(with, true), area(without, true), 1e-14);
  EXPECT_NEAR(area(with, false), area(without, false) + 0.25 * 0.5, 1e-14);
  EXPECT_NEAR(length_above(with, BoundaryRole::wall, top), 0.25, 1e-14);
  EXPECT_NEAR(length_above(with, BoundaryRole::axis, top), 0.25, 1e-14);
  EXPECT_NEAR(length_above(with, BoundaryRole::top, 1.001), 0.5, 1e-14);
  EXPECT_NEAR(length_above(without, BoundaryRole::wall, top), 0., 1e-14);
}



TEST_P(Headroom, OfAWholeSectionHasBothWalls)
{
  silo.is_symmetric  = false;
  silo.headroom      = 0.25;
  const Mesh<2> with = mesh();
  EXPECT_NEAR(length_above(with, BoundaryRole::wall, 0.999), 0.5, 1e-14);
  EXPECT_NEAR(length_above(with, BoundaryRole::top, 1.001), 1., 1e-14);
}



// Material that is thrown up comes back, where it would have left the grid: see
// also FreeFall.IsHeldAtTheTopOfTheGrid.
TEST_P(Headroom, CatchesWhatIsThrownUp)
{
  for (const bool has_headroom : {false, true})
    {
      SCOPED_TRACE(has_headroom);
      silo.outlet_is_open = false;
      silo.headroom       = has_headroom ? 0.2 : 0.;
      StageFixture fixture;
      fixture.parameters.end_time = 1.;
      fixture.parameters.on_lost_particle =
        ParticleStageParameters::OnLostParticle::stop;
      auto &stage = fixture.start(mesh());
      fixture.change_particles([](auto, const auto &, auto state) {
        state[StageLayout::velocity + 1] = 1.; // rises by 0.05 m
      });
      const auto run = [&stage]() {
        while (stage.view().clock().time < 0.5)
          stage.step();
      };
      if (has_headroom)
        {
          EXPECT_NO_THROW(run());
          EXPECT_EQ(stage.removed_mass().lost, 0.);
        }
      else
        try
          {
            run();
            FAIL() << "nothing has left the grid";
          }
        catch (const RunError &error)
          {
            EXPECT_NE(std::string(error.what()).find("Scene/Headroom"),
                      std::string::npos)
              << error.what();
          }
    }
}



TEST_P(Headroom, IsChosenWithTheCells)
{
  EXPECT_EQ(silo.headroom_height(), 0.);
  silo.element_size = {};
  EXPECT_EQ(silo.headroom_height(), 0.1);
  silo.headroom = 0.02;
  EXPECT_EQ(silo.headroom_height(), 0.02);
}

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         Headroom,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
