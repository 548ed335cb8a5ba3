#include <deal.II/base/numbers.h>

#include <sandglass/scene/scene.h>
#include <sandglass/walls/boundary_nodes.h>
#include <sandglass/walls/wall_force.h>

#include <gtest/gtest.h>

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

  double
  total_area(const std::vector<BoundaryNode<2>> &nodes, const BoundaryRole role)
  {
    double area = 0.;
    for (const auto &node : nodes)
      for (const auto &support : node.supports)
        if (support.role == role)
          area += support.tributary_area;
    return area;
  }
} // namespace

TEST(BoundaryNodes, AreasAddUpToTheWalls)
{
  StageFixture fixture;
  Rectangle    rectangle;
  rectangle.upper = Point<2>(0.5, 2.);
  fixture.start(rectangle.mesh());
  const auto plane = find_boundary_nodes(fixture.scene->dof_handler,
                                         Formulation::plane_strain,
                                         fixture.walls);
  EXPECT_NEAR(total_area(plane, BoundaryRole::wall), 2., 1e-14);
  EXPECT_NEAR(total_area(plane, BoundaryRole::floor), 0.5, 1e-14);

  const auto   ring = find_boundary_nodes(fixture.scene->dof_handler,
                                        Formulation::axisymmetric,
                                        fixture.walls);
  const double pi   = dealii::numbers::PI;
  EXPECT_NEAR(total_area(ring, BoundaryRole::wall), 2. * pi * 0.5 * 2., 1e-13);
  EXPECT_NEAR(total_area(ring, BoundaryRole::floor), pi * 0.25, 1e-13);
}

TEST(BoundaryNodes, CornersHaveBothNormals)
{
  StageFixture fixture;
  fixture.start(Rectangle().mesh());
  const auto  nodes  = find_boundary_nodes(fixture.scene->dof_handler,
                                         Formulation::plane_strain,
                                         fixture.walls);
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
  EXPECT_FALSE(node_at(find_boundary_nodes(fixture.scene->dof_handler,
                                           Formulation::plane_strain,
                                           fixture.walls),
                       {1., 0.})
                 ->is_fixed);
}

TEST(BoundaryNodes, OnlyAFreeLipIsFree)
{
  StageFixture fixture;
  Rectangle    rectangle;
  rectangle.left = BoundaryRole::fall_side;
  fixture.start(rectangle.mesh());
  const auto find = [&]() {
    return find_boundary_nodes(fixture.scene->dof_handler,
                               Formulation::plane_strain,
                               fixture.walls);
  };
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
