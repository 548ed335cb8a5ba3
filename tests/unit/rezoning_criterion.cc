// When a mesh has to be made anew, and why.

#include <sandglass/flow/updated_lagrangian/rezoning/element_quality.h>
#include <sandglass/flow/updated_lagrangian/rezoning/rezoning_criterion.h>

#include <gtest/gtest.h>

#include "rezoning_meshes.h"

using namespace RezoningTest;

namespace
{
  /// One triangle (0,0), (1,0), (0,1) with straight edges.
  TriangleMesh
  one_triangle()
  {
    TriangleMesh mesh;
    mesh.nodes.assign(reference_nodes.begin(), reference_nodes.end());
    mesh.cells = {{{0, 1, 2, 3, 4, 5}}};
    find_boundary(mesh, [](unsigned int, unsigned int) {
      return TriangleMesh::free_surface;
    });
    return mesh;
  }
} // namespace



TEST(RezoningCriterion, QualityOfAnElement)
{
  TriangleMesh mesh = one_triangle();
  EXPECT_NEAR(jacobian_ratio(mesh, 0), 1., 1e-14);
  EXPECT_NEAR(smallest_angle(mesh, 0), numbers::PI / 4., 1e-14);

  // The node on edge 0-1 at a quarter of it: the Jacobian at corner 0, where
  // it is 4 x - 1 of what it was, is zero.
  mesh.nodes[3] = Point<2>(0.25, 0.);
  EXPECT_NEAR(jacobian_ratio(mesh, 0), 0., 1e-14);
  mesh.nodes[3] = Point<2>(0.2, 0.);
  EXPECT_LT(jacobian_ratio(mesh, 0), 0.);

  // An edge that bulges inward by h stands at its ends at atan(4 h).
  mesh.nodes[3] = Point<2>(0.5, 0.1);
  EXPECT_NEAR(smallest_angle(mesh, 0),
              numbers::PI / 4. - std::atan(0.4),
              1e-14);

  // Turned over.
  mesh = one_triangle();
  std::swap(mesh.nodes[1], mesh.nodes[2]);
  std::swap(mesh.nodes[3], mesh.nodes[5]);
  EXPECT_NEAR(jacobian_ratio(mesh, 0), -1., 1e-14);
  EXPECT_LT(smallest_angle(mesh, 0), 0.);
}



TEST(RezoningCriterion, ANewMeshIsGood)
{
  const auto worst = find_worst_element(mesh_of(square(), 0.1), {});
  EXPECT_FALSE(worst.needs_rezoning());
  EXPECT_LT(worst.cell, numbers::invalid_unsigned_int);
}



TEST(RezoningCriterion, FindsADistortedElement)
{
  TriangleMesh mesh   = mesh_of(square(), 0.1);
  auto         engine = random_engine();
  for (unsigned int i = 0; i < 20; ++i)
    {
      TriangleMesh       distorted    = mesh;
      const unsigned int cell         = engine() % mesh.cells.size();
      const auto [start, end, middle] = mesh.edge_points(cell, 1);
      // Both cells of this edge have it so: one of them is named.
      distorted.nodes[mesh.cells[cell][4]] = start + 0.22 * (end - start);
      const auto worst                     = find_worst_element(distorted, {});
      EXPECT_TRUE(worst.needs_rezoning());
      EXPECT_EQ(worst.fault, ElementFault::jacobian);
      EXPECT_LT(worst.value, 0.);
      EXPECT_LT(worst.position.distance(middle), 0.1);
      EXPECT_NE(worst.description().find("Jacobian"), std::string::npos);
    }
}



TEST(RezoningCriterion, FindsAFlatElement)
{
  // Squeezed to a tenth of its height.
  TriangleMesh mesh = mesh_of(square(), 0.1);
  for (Point<2> &node : mesh.nodes)
    node[1] *= 0.1;
  const auto worst = find_worst_element(mesh, {});
  EXPECT_TRUE(worst.needs_rezoning());
  EXPECT_EQ(worst.fault, ElementFault::angle);
  EXPECT_LT(worst.value, 0.17);
  EXPECT_EQ(worst.value, smallest_angle(mesh, worst.cell));
  EXPECT_NE(worst.description().find("degrees"), std::string::npos);
}



TEST(RezoningCriterion, FindsACornerInTheMaterial)
{
  const TriangleMesh mesh = mesh_of(square(), 0.1);
  RezoningCriterion  criterion;
  // On the boundary, outside, and by a hundredth of an edge inside.
  criterion.rigid_corners = {Point<2>(0.43, 0.),
                             Point<2>(0.5, -0.3),
                             Point<2>(0.77, 0.001)};
  EXPECT_FALSE(find_worst_element(mesh, criterion).needs_rezoning());

  criterion.rigid_corners.push_back(Point<2>(0.33, 0.005));
  const auto worst = find_worst_element(mesh, criterion);
  EXPECT_TRUE(worst.needs_rezoning());
  EXPECT_EQ(worst.fault, ElementFault::rigid_corner);
  EXPECT_NEAR(worst.value, 0.05, 1e-10);
  EXPECT_LT(worst.position.distance(Point<2>(0.33, 0.)), 0.1);
  EXPECT_NE(worst.description().find("rigid corner"), std::string::npos);
}
