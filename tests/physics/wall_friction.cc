#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>

#include "heap.h"
#include "static_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double degree = numbers::PI / 180.;

  /// Make the faces for which `is_part(center)` holds a wall of this name.
  template <typename IsPart>
  void
  add_wall(Mesh<2> &mesh, const std::string &name, const IsPart &is_part)
  {
    for (auto &face : mesh.faces)
      if (is_part(Point<2>((mesh.vertices[face.vertices[0]] +
                            mesh.vertices[face.vertices[1]]) /
                           2.)))
        face.named_wall = mesh.named_walls.size();
    mesh.named_walls.push_back(name);
  }



  /// What a wall has done together, or a node's part of it.
  struct WallSum
  {
    double       normal = 0., tangential = 0.; ///< in N, or N s
    unsigned int n_nodes = 0;
  };

  void
  add(WallSum &sum, const Tensor<1, 2> &force, const Tensor<1, 2> &normal)
  {
    sum.normal -= force * normal;
    sum.tangential += (force - (force * normal) * normal).norm();
    ++sum.n_nodes;
  }
} // namespace



/**
 * Material settles between an axis and a wall whose lower half has another
 * friction than the upper one, on a floor with a third one. It slides down the
 * walls, so each node's friction is at the limit of the wall that it stands
 * for, also where both halves share a node.
 */
TEST(WallFriction, AtRestEachWallCarriesItsOwnShare)
{
  StaticFixture fixture;
  fixture.walls.friction_angle       = 20.;
  fixture.walls.floor_friction_angle = 30.;
  fixture.walls.friction_angles      = {{"lining", {10.}}};
  fixture.walls.fix_bottom_corner    = false;
  Rectangle rectangle;
  rectangle.upper = Point<2>(0.25, 2.);
  rectangle.n_x   = 5;
  rectangle.n_y   = 40;
  Mesh<2> mesh    = rectangle.mesh();
  add_wall(mesh, "lining", [](const Point<2> &center) {
    return center[0] > 0.25 - 1e-9 && center[1] < 1.;
  });
  fixture.run(mesh);

  const double              scale = fixture.weight();
  std::map<WallId, double>  lift;
  std::map<WallId, WallSum> at_joint, at_corner;
  unsigned int              n_sliding = 0;
  for (const WallForce<2> &force : fixture.state.wall_forces)
    {
      const Wall<2> &wall  = fixture.scene->walls[force.wall];
      const double   limit = wall.friction_coefficient * force.normal_force();
      const double   friction = fixture.tangential_force(force);
      const Point<2> position = fixture.position_of(force);
      EXPECT_LE(std::abs(friction) / scale, limit / scale + 1e-12) << position;
      const bool is_side = wall.role == BoundaryRole::wall;
      if (is_side && position[1] > 0.2 && position[1] < 1.8)
        {
          EXPECT_NEAR(friction / limit, 1., 1e-9) << position;
          ++n_sliding;
        }
      if (is_side && std::abs(position[1] - 1.) < 1e-9)
        add(at_joint[force.wall], force.force, force.normal);
      if (position[0] > 0.25 - 1e-9 && position[1] < 1e-9)
        add(at_corner[force.wall], force.force, force.normal);
      lift[force.wall] += force.force[1];
    }
  EXPECT_EQ(n_sliding, 32u); // 31 nodes, one of them with both
  EXPECT_NEAR(fixture.lift() / scale, 1., 1e-8);

  ASSERT_EQ(at_joint.size(), 2u);
  const WallSum &wall   = at_joint.begin()->second;
  const WallSum &lining = at_joint.rbegin()->second;
  EXPECT_NEAR(wall.normal / lining.normal, 1., 1e-9);
  EXPECT_NEAR(wall.tangential / lining.tangential,
              std::tan(20. * degree) / std::tan(10. * degree),
              1e-9);
  // In the corner, lining and floor.
  EXPECT_EQ(at_corner.size(), 2u);
  for (const auto &[id, sum] : lift)
    std::cout << fixture.scene->walls[id].name << " carries " << sum / scale
              << " of the weight" << std::endl;
}



/**
 * A heap slides over a floor whose right half has less friction than the left
 * one. Friction is at the limit of each wall's own.
 */
TEST(WallFriction, InMotionEachWallCarriesItsOwnShare)
{
  Heap heap;
  heap.fixture.gravity =
    9.81 * Tensor<1, 2>({std::sin(35. * degree), -std::cos(35. * degree)});
  heap.fixture.walls.friction_angle  = 20.;
  heap.fixture.walls.friction_angles = {{"sheet", {10.}}};
  Mesh<2> mesh                       = heap.rectangle.mesh();
  add_wall(mesh, "sheet", [](const Point<2> &center) {
    return center[1] < 1e-9 && center[0] > 1.5;
  });
  heap.fixture.start(mesh);
  heap.run_until(0.1);
  heap.fixture.take_mean_forces();
  heap.run_until(0.25);

  std::map<std::string, WallSum> sums, at_joint;
  for (const MeanWallForce &force : heap.fixture.take_mean_forces())
    {
      const std::string &name = heap.fixture.scene->walls[force.wall].name;
      add(sums[name], force.force, force.normal);
      if (std::abs(force.position[0] - 1.5) < 1e-9 && force.position[1] < 1e-9)
        add(at_joint[name], force.force, force.normal);
    }
  const double mu = std::tan(20. * degree), mu_sheet = std::tan(10. * degree);
  for (const auto &[name, sum] : sums)
    if (sum.normal > 0.)
      {
        const double ratio = sum.tangential / sum.normal;
        std::cout << name << ": friction / normal force " << ratio << std::endl;
        EXPECT_NEAR(ratio, name == "sheet" ? mu_sheet : mu, 0.01 * ratio);
      }
  EXPECT_GT(sums["floor"].normal, 0.);
  EXPECT_GT(sums["sheet"].normal, 0.);
  ASSERT_EQ(at_joint.size(), 2u);
  EXPECT_NEAR(at_joint["floor"].normal / at_joint["sheet"].normal, 1., 1e-9);
  EXPECT_NEAR(at_joint["floor"].tangential / at_joint["sheet"].tangential,
              mu / mu_sheet,
              1e-9);
}
