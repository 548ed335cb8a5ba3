#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>

#include "rest.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double g = 9.81, h = 0.05;

  class FreeJet : public testing::TestWithParam<CellType>
  {
  protected:
    void
    start(const DensityUpdate density_update)
    {
      fixture.parameters.density_update = density_update;
      SceneParameters silo;
      silo.half_width        = 0.4;
      silo.wall_height       = 0.8;
      silo.outlet_half_width = 0.2;
      silo.fall_region_depth = 0.6;
      silo.element_size      = h;
      silo.cell_type         = GetParam();
      fixture.start(mesh_silo(silo));
      start_from_rest(fixture);
    }

    struct Jet
    {
      double mass = 0., stressed_mass = 0., acceleration = 0.;
    };

    /// The jet more than three cells below the outlet, over the steps until
    /// `end` in s: shares of mass and mean acceleration downwards over g.
    Jet
    follow(const double end)
    {
      Jet                                     jet;
      std::map<types::particle_index, double> before;
      while (fixture.stage->clock.time < end)
        {
          before.clear();
          fixture.for_each_particle([&](auto id, const auto &position, auto s) {
            if (position[1] < -3 * h)
              before[id] = s[Property::velocity + 1];
          });
          fixture.stage->step();
          fixture.for_each_particle([&](auto id, auto &, auto state) {
            const auto old = before.find(id);
            if (old == before.end())
              return;
            const double mass = state[Property::mass];
            const Eigen::Map<const SymmetricTensor4> stress(
              &state[Property::stress]);
            jet.mass += mass;
            jet.stressed_mass += stress.norm() > 0. ? mass : 0.;
            jet.acceleration += mass *
                                (old->second - state[Property::velocity + 1]) /
                                fixture.stage->clock.time_step / g;
          });
        }
      jet.acceleration /= jet.mass;
      jet.stressed_mass /= jet.mass;
      return jet;
    }

    StageFixture fixture;
  };
} // namespace



// The jet converges, so that single particles meet and push each other apart;
// all others are stress-free and fall freely. With the paper's density a
// particle that has been separated carries stress again at once: 12 % of the
// mass.
TEST_P(FreeJet, FallsFreelyWithoutStress)
{
  start(DensityUpdate::separation);
  const Jet jet = follow(1.);
  start(DensityUpdate::paper);
  const Jet paper = follow(1.);
  for (const Jet &found : {jet, paper})
    std::cout << "acceleration / g " << found.acceleration
              << ", stressed share of mass " << found.stressed_mass
              << std::endl;
  EXPECT_NEAR(jet.acceleration, 1., 0.015);
  EXPECT_LT(jet.stressed_mass, 0.02);
  EXPECT_GT(paper.stressed_mass, 0.08);
}



INSTANTIATE_TEST_SUITE_P(CellTypes,
                         FreeJet,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
