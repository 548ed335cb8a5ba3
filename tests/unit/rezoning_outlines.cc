// Boundaries of moved material, and what new meshes make of them.

#include <sandglass/base/exceptions.h>
#include <sandglass/flow/updated_lagrangian/rezoning/divide_loop.h>
#include <sandglass/flow/updated_lagrangian/rezoning/element_quality.h>

#include <gtest/gtest.h>

#include <set>

#include "rezoning_meshes.h"

using namespace RezoningTest;

namespace
{
  unsigned int
  n_corners(const BoundaryLoop &loop)
  {
    return std::count_if(loop.begin(), loop.end(), [](const auto &piece) {
      return piece.starts_at_corner;
    });
  }



  double
  area_of(const TriangleMesh &mesh)
  {
    double area = 0.;
    for (const double cell : cell_areas(mesh))
      area += cell;
    return area;
  }



  void
  expect_closed(const BoundaryLoop &loop)
  {
    for (unsigned int i = 0; i < loop.size(); ++i)
      EXPECT_EQ(loop[i].curve[1], loop[(i + 1) % loop.size()].curve[0]);
  }



  void
  expect_sound(const TriangleMesh &mesh)
  {
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      {
        EXPECT_GT(jacobian_ratio(mesh, cell), 0.25);
        EXPECT_GT(smallest_angle(mesh, cell), 0.25);
      }
  }
} // namespace



TEST(RezoningOutlines, SquareWithAHole)
{
  BodyOutline outline = square();
  outline.holes.push_back(reversed(circle(Point<2>(0.5, 0.6), 0.2, 16)));
  for (const unsigned int order : {1, 2})
    {
      const TriangleMesh mesh = mesh_of(outline, 0.1, order);
      EXPECT_EQ(mesh.n_bodies(), 1);
      expect_sound(mesh);

      const auto found = find_outlines(mesh, CornerRule());
      ASSERT_EQ(found.size(), 1);
      ASSERT_EQ(found[0].holes.size(), 1);
      expect_closed(found[0].outside);
      expect_closed(found[0].holes[0]);
      EXPECT_EQ(n_corners(found[0].outside), 4);
      EXPECT_EQ(n_corners(found[0].holes[0]), 0);
      EXPECT_EQ(found[0].outside.size(), 40);
      EXPECT_NEAR(enclosed_area(found[0].outside), 1., 1e-14);
      EXPECT_LT(enclosed_area(found[0].holes[0]), 0.);
      EXPECT_NEAR(found[0].area(), area_of(mesh), 1e-14);
      // The circle's area, to what its edges give.
      EXPECT_NEAR(enclosed_area(found[0].holes[0]),
                  -numbers::PI * 0.04,
                  order == 2 ? 2e-5 : 5e-3);
    }
}



TEST(RezoningOutlines, MarksStayWhereTheyAre)
{
  const TriangleMesh     mesh = mesh_of(square(), 0.1);
  std::set<unsigned int> marks;
  for (const auto &[cell, edge, mark] : mesh.boundary)
    {
      marks.insert(mark);
      const Point<2> middle      = mesh.edge_points(cell, edge)[2];
      const double   distance[4] = {middle[1],
                                    1. - middle[0],
                                    1. - middle[1],
                                    middle[0]};
      ASSERT_LT(mark, 4);
      EXPECT_LT(std::abs(distance[mark]), 1e-15);
    }
  EXPECT_EQ(marks.size(), 4);
}



TEST(RezoningOutlines, TwoBodiesAreTwoOutlines)
{
  const auto mesh =
    mesh_outlines({square(), square(Point<2>(1.3, 0.2), 0.5)}, {0.1}, 2).mesh;
  ASSERT_EQ(mesh.n_bodies(), 2);
  const auto outlines = find_outlines(mesh, CornerRule());
  ASSERT_EQ(outlines.size(), 2);
  EXPECT_NEAR(outlines[0].area(), 1., 1e-14);
  EXPECT_NEAR(outlines[1].area(), 0.25, 1e-14);
  EXPECT_TRUE(outlines[0].holes.empty() && outlines[1].holes.empty());
}



// Two squares whose only common point is a corner: its loops follow the
// material, so that the squares stay two bodies.
TEST(RezoningOutlines, BodiesThatTouchInACorner)
{
  TriangleMesh mesh;
  mesh.order = 1;
  mesh.nodes = {
    {0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}, {2., 1.}, {2., 2.}, {1., 2.}};
  mesh.cells = {{{0, 1, 2}}, {{0, 2, 3}}, {{2, 4, 5}}, {{2, 5, 6}}};
  find_boundary(mesh, [](unsigned int, unsigned int) { return 7; });
  ASSERT_EQ(mesh.n_bodies(), 2);
  const auto outlines = find_outlines(mesh, CornerRule());
  for (const BodyOutline &outline : outlines)
    {
      EXPECT_EQ(outline.outside.size(), 4);
      EXPECT_NEAR(outline.area(), 1., 1e-15);
      EXPECT_TRUE(outline.holes.empty());
    }
}



// A hole that touches the lower side of a square: one loop runs round both,
// and they touch in the new mesh, too.
TEST(RezoningOutlines, ABodyThatTouchesItself)
{
  TriangleMesh mesh;
  mesh.order = 1;
  mesh.nodes = {
    {0., 0.}, {1., 0.}, {2., 0.}, {2., 2.}, {0., 2.}, {1.5, 1.}, {0.5, 1.}};
  mesh.cells = {{{0, 1, 6}},
                {{1, 2, 5}},
                {{2, 3, 5}},
                {{3, 4, 6}},
                {{3, 6, 5}},
                {{4, 0, 6}}};
  find_boundary(mesh, [](unsigned int, unsigned int) {
    return TriangleMesh::free_surface;
  });
  CornerRule rule;
  rule.largest_turn   = 3.; // no corners of its own
  const auto outlines = find_outlines(mesh, rule);
  ASSERT_EQ(outlines.size(), 1);
  EXPECT_TRUE(outlines[0].holes.empty());
  EXPECT_EQ(outlines[0].outside.size(), 8);
  EXPECT_EQ(n_corners(outlines[0].outside), 2);
  EXPECT_NEAR(outlines[0].area(), 3.5, 1e-14);

  const auto result =
    mesh_outlines(find_outlines(mesh, CornerRule()), {0.3}, 2);
  EXPECT_NEAR(area_of(result.mesh), 3.5, 1e-13);
  EXPECT_EQ(find_outlines(result.mesh, CornerRule())[0].holes.size(), 0);
}



// The corner of a wall in the middle of an edge becomes a node of the new mesh,
// and one that is farther away doesn't.
TEST(RezoningOutlines, FixedPointsStay)
{
  CornerRule rule;
  rule.fixed_points   = {Point<2>(0.4321, 0.), Point<2>(0.2, 0.01)};
  const auto outlines = find_outlines(mesh_of(square(), 0.2), rule);
  EXPECT_EQ(n_corners(outlines[0].outside), 5);
  const TriangleMesh mesh    = mesh_outlines(outlines, {0.1}, 2).mesh;
  double             nearest = 1.;
  for (const Point<2> &node : mesh.nodes)
    nearest = std::min(nearest, node.distance(rule.fixed_points[0]));
  EXPECT_LT(nearest, 1e-15);
  EXPECT_NEAR(area_of(mesh), 1., 1e-14);
}



// New edges enclose what the old ones do, to rounding, whatever their sizes.
TEST(RezoningOutlines, ACircleKeepsItsArea)
{
  for (const double size : {0.6, 0.3, 0.11, 0.05})
    {
      std::vector<BodyOutline> outlines = {
        {circle(Point<2>(3., 2.), 1., 12), {}}};
      const double area = outlines[0].area();
      for (unsigned int i = 0; i < 5; ++i)
        {
          const auto result = mesh_outlines(outlines, {size}, 2);
          EXPECT_NEAR(area_of(result.mesh), area, 1e-13);
          EXPECT_NEAR(result.area_gained[0], 0., 1e-13);
          EXPECT_EQ(result.n_straightened, 0);
          expect_sound(result.mesh);
          outlines = find_outlines(result.mesh, CornerRule());
          expect_closed(outlines[0].outside);
        }
    }
}



// Straight edges lose a share of the area that falls with their length's
// square, and say so.
TEST(RezoningOutlines, StraightEdgesLoseArea)
{
  const BodyOutline disc{circle(Point<2>(), 1., 48), {}};
  double            before = 0.;
  for (const double size : {0.2, 0.1, 0.05})
    {
      const auto result = mesh_outlines({disc}, {size}, 1);
      EXPECT_NEAR(area_of(result.mesh) - disc.area(),
                  result.area_gained[0],
                  1e-14);
      EXPECT_LT(result.area_gained[0], 0.);
      if (before != 0.)
        {
          EXPECT_NEAR(before / result.area_gained[0], 4., 0.4);
        }
      before = result.area_gained[0];
    }
}



TEST(RezoningOutlines, EdgesHaveTheWantedLengths)
{
  const SizeField size{0.2, {{Point<2>(1., 0.), 0.02, 0.2}}};
  const auto      mesh = mesh_outlines({square()}, size, 2).mesh;
  expect_sound(mesh);
  double mean = 0.;
  for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
    {
      const auto [start, end, middle] = mesh.edge_points(cell, 0);
      const double ratio              = start.distance(end) / size.at(middle);
      EXPECT_GT(ratio, 0.4);
      EXPECT_LT(ratio, 2.);
      mean += ratio / mesh.cells.size();
    }
  EXPECT_NEAR(mean, 1., 0.15);
}



TEST(RezoningOutlines, TheSameAgain)
{
  const BodyOutline disc{circle(Point<2>(), 1., 12), {}};
  const auto        first = mesh_of(disc, 0.1), second = mesh_of(disc, 0.1);
  EXPECT_EQ(first.nodes, second.nodes);
  EXPECT_EQ(first.cells, second.cells);
}



TEST(RezoningOutlines, ASurfaceThatCrossesItselfIsRefused)
{
  EXPECT_THROW(mesh_of({polygon({Point<2>(0., 0.),
                                 Point<2>(1., 1.),
                                 Point<2>(1., 0.),
                                 Point<2>(0., 2.)}),
                        {}},
                       0.1),
               RunError);
}
