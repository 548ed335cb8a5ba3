// The free surface is smoothed, and turned to walls, with its area kept.

#include <sandglass/flow/updated_lagrangian/motion/surface_at_walls.h>
#include <sandglass/flow/updated_lagrangian/rezoning/smooth_surface.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <gtest/gtest.h>

#include <cmath>

#include "../updated_lagrangian_fixture.h"

using namespace Sandglass;

namespace
{
  /// Straight pieces through points, all of the free surface.
  BoundaryLoop
  loop_through(const std::vector<Point<2>> &points)
  {
    BoundaryLoop loop;
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        const Point<2> &a = points[i], &b = points[(i + 1) % points.size()];
        loop.push_back(
          {{{a, b, a + (b - a) / 2.}}, TriangleMesh::free_surface, false});
      }
    return loop;
  }



  double
  largest_turn(const BoundaryLoop &loop)
  {
    double largest = 0.;
    for (unsigned int i = 0; i < loop.size(); ++i)
      {
        const auto &next     = loop[(i + 1) % loop.size()].curve;
        const auto  arriving = derivative_on_curve(loop[i].curve, 1.);
        const auto  leaving  = derivative_on_curve(next, 0.);
        largest              = std::max(largest,
                           std::abs(std::atan2(cross(arriving, leaving),
                                               arriving * leaving)));
      }
    return largest;
  }
} // namespace



TEST(RezoningSurface, SpikesAreSmoothed)
{
  std::vector<Point<2>> points;
  for (unsigned int i = 0; i < 24; ++i)
    {
      const double angle = 2. * numbers::PI * i / 24.;
      const double r     = i == 5 ? 1.6 : i == 16 ? 0.7 : 1.;
      points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
  BoundaryLoop loop = loop_through(points);
  // One piece is curved.
  loop[10].curve[2] += 0.03 * Tensor<1, 2>(loop[10].curve[2]);
  const double area = enclosed_area(loop);
  ASSERT_GT(largest_turn(loop), 1.);
  EXPECT_GT(smooth_surface(loop, 1.), 0);
  EXPECT_LE(largest_turn(loop), 1.);
  EXPECT_NEAR(enclosed_area(loop) / area, 1., 1e-14);
  for (unsigned int i = 0; i < loop.size(); ++i)
    EXPECT_EQ(loop[i].curve[1], loop[(i + 1) % loop.size()].curve[0]);
  // Nothing is left to do.
  EXPECT_EQ(smooth_surface(loop, 1.), 0);
}



// A tongue beside the right wall of a box, and one that bends away from it.
TEST(RezoningSurface, TurnsToWalls)
{
  UpdatedLagrangianFixture fixture;
  Rectangle                rectangle;
  rectangle.n_x = rectangle.n_y = 10;
  fixture.start(rectangle.mesh());
  const MotionSetting setting(*fixture.scene,
                              fixture.material,
                              fixture.walls,
                              fixture.parameters,
                              fixture.static_parameters);
  for (const bool is_gap : {false, true})
    {
      std::vector<Point<2>> points{{0., 0.}, {1., 0.}, {1., 0.4}};
      if (is_gap)
        {
          points.emplace_back(0.99, 0.5);
          points.emplace_back(0.97, 0.6);
        }
      else
        points.emplace_back(1., 0.6);
      for (const double x : {0.95, 0.9, 0.7, 0.5, 0.3})
        points.emplace_back(x, 0.45);
      points.emplace_back(0., 0.45);
      BoundaryLoop loop = loop_through(points);
      const double area = enclosed_area(loop);
      EXPECT_EQ(turn_surface_to_walls(loop, smallest_surface_angles, setting),
                1);
      EXPECT_EQ(turn_surface_to_walls(loop, smallest_surface_angles, setting),
                0);
      EXPECT_NEAR(enclosed_area(loop) / area, 1., 1e-14);
      double highest = 0.;
      for (unsigned int i = 0; i < loop.size(); ++i)
        {
          EXPECT_EQ(loop[i].curve[1], loop[(i + 1) % loop.size()].curve[0]);
          highest = std::max(highest, loop[i].curve[0][1]);
        }
      EXPECT_LT(highest, 0.55);
    }
}
