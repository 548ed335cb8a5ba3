#include <deal.II/base/numbers.h>

#include <sandglass/scene/scene.h>
#include <sandglass/walls/boundary_nodes.h>
#include <sandglass/walls/section_tangent.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  const BoundaryNode<2> *
  node_at(const std::vector<BoundaryNode<2>> &nodes, const Point<2> &position)
  {
    for (const auto &node : nodes)
      if (node.position.distance(position) < 1e-12)
        return &node;
    return nullptr;
  }

  /// Of all walls with this name.
  double
  total_area(const StageFixture                 &fixture,
             const std::vector<BoundaryNode<2>> &nodes,
             const std::string                  &wall)
  {
    double area = 0.;
    for (const auto &node : nodes)
      for (const auto &support : node.supports)
        for (const auto &share : support.walls)
          if (fixture.scene->walls[share.wall].name == wall)
            area += share.area;
    return area;
  }

  std::vector<BoundaryNode<2>>
  find_nodes(const StageFixture &fixture,
             const Formulation   formulation = Formulation::plane_strain)
  {
    return find_boundary_nodes(fixture.scene->dof_handler,
                               formulation,
                               fixture.scene->walls,
                               fixture.walls);
  }
} // namespace

TEST(BoundaryNodes, AreasAddUpToTheWalls)
{
  StageFixture fixture;
  Rectangle    rectangle;
  rectangle.upper = Point<2>(0.5, 2.);
  fixture.start(rectangle.mesh());
  const auto plane = find_nodes(fixture);
  EXPECT_NEAR(total_area(fixture, plane, "wall"), 2., 1e-14);
  EXPECT_NEAR(total_area(fixture, plane, "floor"), 0.5, 1e-14);

  const auto   ring = find_nodes(fixture, Formulation::axisymmetric);
  const double pi   = dealii::numbers::PI;
  EXPECT_NEAR(total_area(fixture, ring, "wall"), 2. * pi * 0.5 * 2., 1e-13);
  EXPECT_NEAR(total_area(fixture, ring, "floor"), pi * 0.25, 1e-13);
}

TEST(BoundaryNodes, CornersHaveBothNormals)
{
  StageFixture fixture;
  fixture.start(Rectangle().mesh());
  const auto  nodes  = find_nodes(fixture);
  const auto *corner = node_at(nodes, {1., 0.});
  ASSERT_NE(corner, nullptr);
  EXPECT_EQ(corner->supports.size(), 2u);
  EXPECT_TRUE(corner->is_fixed);

  const auto *wall_top = node_at(nodes, {1., 1.});
  ASSERT_NE(wall_top, nullptr);
  ASSERT_EQ(wall_top->supports.size(), 1u);
  EXPECT_NEAR((wall_top->supports[0].normal - Tensor<1, 2>({1., 0.})).norm(),
              0.,
              1e-15);
  EXPECT_EQ(node_at(nodes, {0.5, 0.5}), nullptr);
  EXPECT_EQ(node_at(nodes, {0.5, 1.}), nullptr) << "the top holds nothing";

  fixture.walls.fix_bottom_corner = false;
  EXPECT_FALSE(node_at(find_nodes(fixture), {1., 0.})->is_fixed);
}

TEST(BoundaryNodes, OnlyAFreeLipIsFree)
{
  StageFixture fixture;
  Rectangle    rectangle;
  rectangle.left = BoundaryRole::fall_side;
  fixture.start(rectangle.mesh());
  const auto find          = [&]() { return find_nodes(fixture); };
  fixture.walls.outlet_lip = WallParameters::OutletLip::floor;
  const auto with_lip      = find();
  ASSERT_NE(node_at(with_lip, {0., 0.}), nullptr);
  EXPECT_TRUE(node_at(with_lip, {0., 0.})->is_outlet_lip);
  EXPECT_FALSE(node_at(with_lip, {0., 0.})->is_free);

  fixture.walls.outlet_lip = WallParameters::OutletLip::free;
  const auto with_free_lip = find();
  EXPECT_TRUE(node_at(with_free_lip, {0., 0.})->is_free);
  EXPECT_FALSE(node_at(with_free_lip, {1., 0.})->is_free);
}

TEST(BoundaryNodes, TangentsPointUpOrRight)
{
  const auto expect_tangent = [](const Tensor<1, 2> &normal,
                                 const Tensor<1, 2> &tangent) {
    EXPECT_NEAR((wall_tangent(normal) - tangent).norm(), 0., 1e-15);
  };
  expect_tangent(Tensor<1, 2>({1., 0.}), Tensor<1, 2>({0., 1.}));
  expect_tangent(Tensor<1, 2>({-1., 0.}), Tensor<1, 2>({0., 1.}));
  expect_tangent(Tensor<1, 2>({0., -1.}), Tensor<1, 2>({1., 0.}));
  expect_tangent(Tensor<1, 2>({0.8, -0.6}), Tensor<1, 2>({0.6, 0.8}));
}

// A wall of two parts at the right, whose lower half is a wall of its own, and
// a closed outlet at the left of the floor.
TEST(BoundaryNodes, WallsInAPlaneAreOneSupportWithTheirShares)
{
  StageFixture fixture;
  fixture.walls.friction_angle       = 20.;
  fixture.walls.floor_friction_angle = 30.;
  fixture.walls.friction_angles      = {{"lining", {10.}}};
  Mesh<2> mesh                       = Rectangle().mesh();
  mesh.named_walls                   = {"lining"};
  for (auto &face : mesh.faces)
    {
      const Point<2> &start = mesh.vertices[face.vertices[0]];
      if (face.role == BoundaryRole::wall && start[1] < 0.4)
        face.named_wall = 0;
      if (face.role == BoundaryRole::floor && start[0] < 0.2)
        face.role = BoundaryRole::outlet;
    }
  fixture.start(mesh);
  const auto &walls = fixture.scene->walls;
  ASSERT_EQ(walls.size(), 4u);
  const auto nodes = find_nodes(fixture);
  EXPECT_NEAR(total_area(fixture, nodes, "wall"), 0.5, 1e-14);
  EXPECT_NEAR(total_area(fixture, nodes, "lining"), 0.5, 1e-14);
  // Its end belongs to the floor beside it.
  EXPECT_NEAR(total_area(fixture, nodes, "outlet"), 0.125, 1e-14);
  EXPECT_NEAR(total_area(fixture, nodes, "floor"), 0.875, 1e-14);

  const auto *middle = node_at(nodes, {1., 0.5});
  ASSERT_NE(middle, nullptr);
  ASSERT_EQ(middle->supports.size(), 1u);
  ASSERT_EQ(middle->supports[0].walls.size(), 2u);
  const double mu        = std::tan(20. * numbers::PI / 180.);
  const double mu_lining = std::tan(10. * numbers::PI / 180.);
  EXPECT_NEAR(middle->supports[0].area, 0.25, 1e-15);
  EXPECT_NEAR(middle->supports[0].friction_coefficient,
              (mu + mu_lining) / 2.,
              1e-15);
  for (const WallShare &share : middle->supports[0].walls)
    {
      const Wall<2> &wall = walls[share.wall];
      EXPECT_NEAR(share.of_normal_force, 0.5, 1e-15);
      EXPECT_NEAR(share.of_friction,
                  wall.friction_coefficient / (mu + mu_lining),
                  1e-15);
      EXPECT_NEAR(wall.friction_coefficient,
                  wall.name == "lining" ? mu_lining : mu,
                  1e-15);
    }

  // The closed outlet belongs to the floor.
  const auto *lip = node_at(nodes, {0.25, 0.});
  ASSERT_NE(lip, nullptr);
  ASSERT_EQ(lip->supports.size(), 1u);
  EXPECT_EQ(lip->supports[0].walls.size(), 1u);
  EXPECT_EQ(lip->supports[0].friction_coefficient,
            std::tan(30. * numbers::PI / 180.));
}

// Friction pulls the material along with the mean of the walls' velocities by
// their shares of the friction, not of the area.
TEST(BoundaryNodes, WallsInAPlanePullWithTheirSharesOfFriction)
{
  StageFixture fixture;
  fixture.walls.friction_angle  = 20.;
  fixture.walls.friction_angles = {{"lining", {10.}}};
  fixture.walls.velocities      = {{"lining", {0., 0.5}}, {"wall", {0., -0.1}}};
  Mesh<2> mesh                  = Rectangle().mesh();
  mesh.named_walls              = {"lining"};
  for (auto &face : mesh.faces)
    if (face.role == BoundaryRole::wall &&
        mesh.vertices[face.vertices[0]][1] < 0.4)
      face.named_wall = 0;
  fixture.start(mesh);
  const auto  nodes  = find_nodes(fixture);
  const auto *middle = node_at(nodes, {1., 0.5});
  ASSERT_NE(middle, nullptr);
  ASSERT_EQ(middle->supports.size(), 1u);
  const double mu        = std::tan(20. * numbers::PI / 180.);
  const double mu_lining = std::tan(10. * numbers::PI / 180.);
  EXPECT_NEAR(middle->supports[0].velocity[1],
              (0.5 * mu_lining - 0.1 * mu) / (mu + mu_lining),
              1e-14);
  EXPECT_EQ(middle->supports[0].velocity[0], 0.);
}

// With a friction of its own it carries its own share on its edge too.
TEST(BoundaryNodes, AClosedOutletWithAFrictionOfItsOwnKeepsItsEdge)
{
  StageFixture fixture;
  fixture.walls.friction_angles = {{"outlet", {10.}}};
  Mesh<2> mesh                  = Rectangle().mesh();
  for (auto &face : mesh.faces)
    if (face.role == BoundaryRole::floor &&
        mesh.vertices[face.vertices[0]][0] < 0.2)
      face.role = BoundaryRole::outlet;
  fixture.start(mesh);
  const auto nodes = find_nodes(fixture);
  EXPECT_NEAR(total_area(fixture, nodes, "outlet"), 0.25, 1e-14);
  EXPECT_NEAR(total_area(fixture, nodes, "floor"), 0.75, 1e-14);
}
