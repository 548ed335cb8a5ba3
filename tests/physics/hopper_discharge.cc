#include <sandglass/scene/make_mesh.h>
#include <sandglass/walls/boundary_nodes.h>

#include <gtest/gtest.h>

#include <cmath>

#include "rest.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  struct Hopper
  {
    Formulation formulation;
    double      half_width, wall_height, outlet_half_width, hopper_height,
      fall_region_depth, element_size; // in m
  };

  // The paper's silos on coarse meshes, and the same with shallow hoppers.
  const Hopper steep_trapezoid =
    {Formulation::plane_strain, 0.80, 1.25, 0.225, 1.10, 0.65, 0.1};
  const Hopper shallow_trapezoid =
    {Formulation::plane_strain, 0.80, 1.25, 0.225, 0.30, 0.65, 0.1};
  const Hopper steep_cone =
    {Formulation::axisymmetric, 0.12, 0.24, 0.05, 0.14, 0.075, 0.0125};
  const Hopper shallow_cone =
    {Formulation::axisymmetric, 0.12, 0.24, 0.05, 0.04, 0.075, 0.0125};

  using Case = std::tuple<Hopper, CellType>;

  class HopperTest : public testing::TestWithParam<Case>
  {
  protected:
    HopperTest()
    {
      const auto &[hopper, cell_type] = GetParam();
      SceneParameters silo;
      silo.half_width             = hopper.half_width;
      silo.wall_height            = hopper.wall_height;
      silo.outlet_half_width      = hopper.outlet_half_width;
      silo.hopper_height          = hopper.hopper_height;
      silo.fall_region_depth      = hopper.fall_region_depth;
      silo.element_size           = hopper.element_size;
      silo.cell_type              = cell_type;
      fixture.formulation         = hopper.formulation;
      fixture.parameters.end_time = 3.;
      fixture.start(mesh_silo<2>(silo));
      transition = Point<2>(hopper.half_width, hopper.hopper_height);
      for (const auto &node : find_boundary_nodes(fixture.scene->dof_handler,
                                                  hopper.formulation,
                                                  fixture.scene->walls,
                                                  fixture.walls))
        if (node.position.distance(transition) < 1e-9)
          corner = node;

      // Throws where it doesn't converge.
      start_from_rest(fixture);
    }

    double
    mass_in_grid() const
    {
      double mass = 0.;
      fixture.for_each_particle(
        [&](auto, auto &, auto state) { mass += state[StageLayout::mass]; });
      return mass;
    }

    /// v^L of the corner node into the wall that it enters fastest, in m/s.
    double
    corner_velocity_into_wall() const
    {
      const double *value = fixture.stage->nodal_fields().mapped_velocity.at(
        fixture.scene->nodes->global_to_local(corner.dof));
      double largest = -1e300;
      for (const auto &support : corner.supports)
        largest =
          std::max(largest,
                   value[0] * support.normal[0] + value[1] * support.normal[1]);
      return largest;
    }

    StageFixture    fixture;
    BoundaryNode<2> corner;
    Point<2>        transition;
  };
} // namespace



TEST_P(HopperTest, BothWallsSupportTheNodeWhereTheyMeet)
{
  const Hopper &hopper = std::get<0>(GetParam());
  ASSERT_EQ(corner.supports.size(), 2u);
  EXPECT_FALSE(corner.is_fixed);
  Tensor<1, 2> inclined(
    {hopper.hopper_height, hopper.outlet_half_width - hopper.half_width});
  inclined /= inclined.norm();
  for (const auto &support : corner.supports)
    {
      ASSERT_EQ(support.walls.size(), 1u);
      const BoundaryRole role        = fixture.role_of(support.walls[0].wall);
      const bool         is_vertical = role == BoundaryRole::wall;
      EXPECT_TRUE(is_vertical || role == BoundaryRole::hopper);
      EXPECT_NEAR((support.normal -
                   (is_vertical ? Tensor<1, 2>({1., 0.}) : inclined))
                    .norm(),
                  0.,
                  1e-12);
    }
}



// With the default 'On lost particle = hold', a particle that leaves through a
// wall throws.
TEST_P(HopperTest, DischargesWithoutLosingAParticle)
{
  auto        &stage   = *fixture.stage;
  const double initial = mass_in_grid();
  const double speed   = std::sqrt(2. * 9.81 * transition[1]);

  double largest_into_wall = -1e300;
  while (!stage.is_finished())
    {
      ASSERT_NO_THROW(stage.step());
      largest_into_wall =
        std::max(largest_into_wall, corner_velocity_into_wall() / speed);
    }
  const double discharged = stage.removed_mass().discharged;
  const double lost       = stage.removed_mass().lost;
  const double balance    = (mass_in_grid() + discharged + lost) / initial - 1.;
  std::cout << "discharged / initial mass            " << discharged / initial
            << "\nerror of the mass balance            " << balance
            << "\nv^L into the corner / sqrt(2 g e)    " << largest_into_wall
            << "\nsteps                                "
            << stage.view().clock().step << std::endl;
  EXPECT_EQ(lost, 0.);
  EXPECT_NEAR(balance, 0., 1e-12);
  EXPECT_GT(discharged / initial, 0.3);
  // Rounding of a projection.
  EXPECT_LT(largest_into_wall, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(
  Hoppers,
  HopperTest,
  testing::Combine(testing::Values(steep_trapezoid,
                                   shallow_trapezoid,
                                   steep_cone,
                                   shallow_cone),
                   testing::Values(CellType::triangle,
                                   CellType::quadrilateral)),
  [](const auto &info) {
    const Hopper &hopper = std::get<0>(info.param);
    return std::string(hopper.hopper_height > hopper.half_width ? "Steep" :
                                                                  "Shallow") +
           (hopper.formulation == Formulation::plane_strain ? "Trapezoid" :
                                                              "Cone") +
           (std::get<1>(info.param) == CellType::triangle ? "Triangles" :
                                                            "Quadrilaterals");
  });
