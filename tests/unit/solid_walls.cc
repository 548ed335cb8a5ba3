#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>

#include <sandglass/scene/scene.h>
#include <sandglass/walls/boundary_nodes.h>
#include <sandglass/walls/corner.h>
#include <sandglass/walls/facets.h>
#include <sandglass/walls/friction_cones.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "box_mesh.h"
#include "random_engine.h"

using namespace Sandglass;

namespace
{
  class SolidWalls : public testing::TestWithParam<CellType>
  {};

  Support<3>
  rough_wall(const Tensor<1, 3> &normal, const double coefficient)
  {
    Support<3> support;
    support.normal               = normal / normal.norm();
    support.friction_coefficient = coefficient;
    return support;
  }

  Tensor<1, 3>
  vector_of(const double x, const double y, const double z)
  {
    return Tensor<1, 3>({x, y, z});
  }
} // namespace

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         SolidWalls,
                         testing::Values(CellType::hexahedron,
                                         CellType::tetrahedron));

TEST_P(SolidWalls, NodesOfABoxHaveASupportForEachSideTheyAreOn)
{
  Box box;
  box.cell_type   = GetParam();
  box.n           = {{3, 4, 5}};
  box.upper       = Point<3>(1., 2., 3.);
  box.roles[0][0] = BoundaryRole::axis;
  const Scene<3> scene(box.mesh(),
                       WallParameters(),
                       Formulation::three_dimensions,
                       8,
                       Tensor<1, 3>(),
                       MPI_COMM_SELF);
  EXPECT_EQ(scene.symmetry_factor, 2.);

  // The top holds nothing.
  double       area = 0.;
  unsigned int n    = 0;
  for (const auto &node : find_boundary_nodes(
         scene.dof_handler, scene.formulation, scene.walls, WallParameters()))
    {
      const Point<3> &p        = node.position;
      const unsigned  expected = (p[0] == 0.) + (p[0] == 1.) + (p[1] == 0.) +
                                (p[2] == 0.) + (p[2] == 3.);
      EXPECT_EQ(node.supports.size(), expected) << p;
      for (const auto &support : node.supports)
        {
          EXPECT_NEAR(support.normal.norm(), 1., 1e-14);
          EXPECT_EQ(support.is_axis, support.normal[0] < -0.5);
          area += support.area;
        }
      ++n;
    }
  EXPECT_EQ(n, 4u * 5 * 6 - 2 * 3 * 4 - 2 * 4);
  EXPECT_NEAR(area, 2 * 2. * 3. + 1. * 3. + 2 * 1. * 2., 1e-12);
}

// The outlet of a quarter: its edge ends at the symmetry planes, and is free
// there as it is elsewhere.
TEST_P(SolidWalls, TheLipReachesTheSymmetryPlanes)
{
  constexpr double outlet = 1. / 3., rounding = 1e-12;
  Box              box;
  box.cell_type   = GetParam();
  box.n           = {{3, 3, 3}};
  box.roles       = {{{{BoundaryRole::axis, BoundaryRole::wall}},
                      {{BoundaryRole::fall_bottom, BoundaryRole::top}},
                      {{BoundaryRole::axis, BoundaryRole::wall}}}};
  box.is_left_out = [&](const Point<3> &p) {
    return p[1] < outlet && std::max(p[0], p[2]) > outlet;
  };
  box.role_at_gap = [&](const Point<3> &p) {
    return std::abs(p[1] - outlet) < rounding ? BoundaryRole::floor :
                                                BoundaryRole::fall_side;
  };
  const WallParameters parameters;
  const Scene<3>       scene(box.mesh(),
                       parameters,
                       Formulation::three_dimensions,
                       8,
                       Tensor<1, 3>(),
                       MPI_COMM_SELF);
  for (const auto &node : find_boundary_nodes(
         scene.dof_handler, scene.formulation, scene.walls, parameters))
    {
      const Point<3> &p = node.position;
      EXPECT_EQ(node.is_free,
                std::abs(p[1] - outlet) < rounding &&
                  std::abs(std::max(p[0], p[2]) - outlet) < rounding)
        << p;
    }
}

TEST(Facets, OfACurvedWallBecomeOneDirection)
{
  Facets<3> facets;
  for (const double angle : {0.2, 0., -0.2, 0.2, 0., -0.2})
    facets.push_back({vector_of(std::cos(angle), 0., std::sin(angle)), 0, 1.});
  facets.push_back({vector_of(0., -1., 0.), 1, 1.});
  unite_directions(facets);
  for (unsigned int f = 0; f < 6; ++f)
    EXPECT_LT((facets[f].normal - vector_of(1., 0., 0.)).norm(), 1e-14);
  EXPECT_EQ(facets[6].normal, vector_of(0., -1., 0.));
}

TEST(Facets, OfASquareSiloKeepTheirDirections)
{
  const Facets<3> before{{vector_of(1., 0., 0.), 0, 1.},
                         {vector_of(0., 0., 1.), 0, 1.},
                         {vector_of(0., -1., 0.), 1, 1.}};
  Facets<3>       facets = before;
  unite_directions(facets);
  for (unsigned int f = 0; f < 3; ++f)
    EXPECT_EQ(facets[f].normal, before[f].normal);
}

// The walls of a square silo, and below each a side of a pyramid.
TEST(Facets, InTheCornerAboveAPyramidUniteEachWallWithItsSide)
{
  Facets<3> facets{{vector_of(1., 0., 0.), 0, 1.},
                   {vector_of(0., 0., 1.), 0, 1.},
                   {vector_of(0.8, -0.6, 0.), 1, 1.},
                   {vector_of(0., -0.6, 0.8), 1, 1.}};
  unite_directions(facets);
  const Tensor<1, 3> expected = vector_of(1.8, -0.6, 0.);
  EXPECT_LT((facets[0].normal - expected / expected.norm()).norm(), 1e-14);
  EXPECT_EQ(facets[0].normal, facets[2].normal);
  EXPECT_EQ(facets[1].normal, facets[3].normal);
  EXPECT_NEAR(facets[1].normal[2], facets[0].normal[0], 1e-14);
}

// Sums of what rough walls can exert are within their cones; what the nearest
// force beyond them would be is not.
TEST(SolidFrictionCones, ContainSumsOfWhatTheWallsExertAndNothingElse)
{
  auto                                   engine = random_engine(4);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  const double                           mu = 0.3;
  const Supports<3> supports{rough_wall(vector_of(1., 0., 0.2), mu),
                             rough_wall(vector_of(0., -1., 0.), mu),
                             rough_wall(vector_of(0.1, 0., 1.), mu)};
  for (unsigned int n = 2; n <= 3; ++n)
    {
      const Supports<3>      walls(supports.begin(), supports.begin() + n);
      const FrictionCones<3> cones(walls);
      ASSERT_TRUE(cones.are_several());
      for (unsigned int i = 0; i < 300; ++i)
        {
          // Sixteen forces for a circle reach 0.98 of its radius at least.
          Tensor<1, 3> sum;
          for (const auto &wall : walls)
            {
              Tensor<1, 3> along = wall.tangential(
                vector_of(uniform(engine), uniform(engine), uniform(engine)));
              along /= along.norm();
              const double press = 1. + uniform(engine);
              sum += press * (-wall.normal +
                              0.98 * mu * std::abs(uniform(engine)) * along);
            }
          EXPECT_TRUE(cones.contain(sum));

          // The polar cone of all the walls' cones: v with v . f <= 0 for all
          // forces f. A force is in the sum of the cones unless some v of the
          // polar cone has v . force > 0.
          const Tensor<1, 3> force =
            vector_of(uniform(engine), uniform(engine), uniform(engine));
          bool is_separated = false;
          for (unsigned int trial = 0; trial < 300 && !is_separated; ++trial)
            {
              const Tensor<1, 3> v =
                vector_of(uniform(engine), uniform(engine), uniform(engine));
              double largest = -1.;
              for (const auto &wall : walls)
                largest =
                  std::max(largest,
                           -(v * wall.normal) + mu * wall.tangential(v).norm());
              is_separated = largest <= 0. && v * force > 0.;
            }
          if (is_separated)
            {
              EXPECT_FALSE(cones.contain(force)) << force;
            }
        }
    }
}

TEST(SolidFrictionCones, OfSmoothWallsAreNoCornerOfTwoButOneOfThree)
{
  const Support<3> x = rough_wall(vector_of(1., 0., 0.), 0.),
                   y = rough_wall(vector_of(0., -1., 0.), 0.),
                   z = rough_wall(vector_of(0., 0., 1.), 0.);
  EXPECT_FALSE(FrictionCones<3>(Supports<3>{x, y}).are_several());
  const FrictionCones<3> three(Supports<3>{x, y, z});
  EXPECT_TRUE(three.contain(vector_of(-1., 2., -0.5)));
  EXPECT_FALSE(three.contain(vector_of(0.1, 2., -0.5)));
}

// In a corner of three walls each set of supports holds where it should.
TEST(SolidCorner, HoldsWhatGoesIntoItsWalls)
{
  const Supports<3> supports{rough_wall(vector_of(1., 0., 0.), 0.),
                             rough_wall(vector_of(0., -1., 0.), 0.),
                             rough_wall(vector_of(0., 0., 1.), 0.)};
  for (unsigned int signs = 0; signs < 8; ++signs)
    {
      const Tensor<1, 3> velocity = vector_of(signs & 1u ? 1. : -1.,
                                              signs & 2u ? -2. : 2.,
                                              signs & 4u ? 3. : -3.);
      const SupportSet held = holding_supports<3>(supports, velocity);
      EXPECT_EQ(held, signs);
      const Tensor<1, 3> left =
        HeldDirections<3>(supports, held).left_of(velocity);
      for (const auto &support : supports)
        EXPECT_LE(left * support.normal, 0.);
    }
}
