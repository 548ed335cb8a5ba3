// Material that has passed a level, and bodies that part.

#include <sandglass/flow/updated_lagrangian/rezoning/cut_off.h>

#include <gtest/gtest.h>

#include <numeric>

#include "rezoning_meshes.h"

using namespace RezoningTest;

namespace
{
  const SizeField size{0.1};

  /// Masses of the cells of a mesh with density 1000 (1 + x^2/10).
  std::vector<double>
  masses_of(const TriangleMesh &mesh)
  {
    const QGaussSimplex<2> quadrature(2);
    const MeshState        state = make_state(mesh, quadrature, {}, {});
    return cell_masses(mesh, quadrature, plane, state.density);
  }

  double
  total(const std::vector<double> &masses)
  {
    return std::accumulate(masses.begin(), masses.end(), 0.);
  }
} // namespace



TEST(RezoningCutOff, AllMassIsCounted)
{
  const TriangleMesh mesh   = mesh_of(square(), 0.1);
  const auto         masses = masses_of(mesh);
  EXPECT_NEAR(total(masses), 1000. * (1. + 0.1 / 3.), 1e-9);

  const CutOff left = cut_off(mesh, masses, 0.35, size, 0.5);
  EXPECT_TRUE(left.is_cut());
  EXPECT_EQ(left.cells.size() + left.n_cells_below, mesh.cells.size());
  EXPECT_EQ(left.n_cells_sliver, 0);
  EXPECT_NEAR(total(masses_of(left.mesh)) + left.mass_below,
              total(masses),
              1e-10);
  EXPECT_GT(left.mass_below, 150.);
  EXPECT_LT(left.mass_below, 350.);

  // Every cell that is left reaches above, and what was the inside is free.
  for (unsigned int cell = 0; cell < left.mesh.cells.size(); ++cell)
    {
      double highest = 0.;
      for (const unsigned int node : left.mesh.cells[cell])
        highest = std::max(highest, left.mesh.nodes[node][1]);
      EXPECT_GT(highest, 0.35);
    }
  unsigned int n_floor = 0, n_free = 0;
  for (const auto &edge : left.mesh.boundary)
    {
      n_floor += edge.mark == 0;
      n_free += edge.mark == TriangleMesh::free_surface;
    }
  EXPECT_EQ(n_floor, 0);
  EXPECT_GT(n_free, 8);

  // Fields follow.
  const MeshField x =
    values_at(mesh.nodes, {[](const Point<2> &p) { return p[0]; }});
  const MeshField x_left = x.at_blocks(left.nodes);
  ASSERT_EQ(x_left.values.size(), left.mesh.nodes.size());
  for (unsigned int i = 0; i < left.nodes.size(); ++i)
    EXPECT_EQ(x_left.values[i], left.mesh.nodes[i][0]);
}



TEST(RezoningCutOff, NothingToCut)
{
  const TriangleMesh mesh = mesh_of(square(), 0.1);
  const CutOff       left = cut_off(mesh, masses_of(mesh), -0.1, size, 0.5);
  EXPECT_FALSE(left.is_cut());
  EXPECT_EQ(left.mass_below, 0.);
  EXPECT_EQ(left.mesh.cells.size(), mesh.cells.size());
  EXPECT_EQ(left.mesh.nodes.size(), mesh.nodes.size());
}



TEST(RezoningCutOff, AllIsCut)
{
  const TriangleMesh mesh   = mesh_of(square(), 0.1);
  const auto         masses = masses_of(mesh);
  const CutOff       left   = cut_off(mesh, masses, 2., size, 0.5);
  EXPECT_TRUE(left.mesh.cells.empty());
  EXPECT_NEAR(left.mass_below, total(masses), 1e-10);
}



// A trough whose bottom is cut off leaves its two walls.
TEST(RezoningCutOff, ABodyParts)
{
  const BodyOutline  trough{polygon({Point<2>(0., 0.),
                                     Point<2>(1.5, 0.),
                                     Point<2>(1.5, 1.),
                                     Point<2>(1., 1.),
                                     Point<2>(1., 0.3),
                                     Point<2>(0.5, 0.3),
                                     Point<2>(0.5, 1.),
                                     Point<2>(0., 1.)}),
                           {}};
  const TriangleMesh mesh = mesh_of(trough, 0.1);
  ASSERT_EQ(mesh.n_bodies(), 1);
  const CutOff left = cut_off(mesh, masses_of(mesh), 0.35, size, 0.5);
  EXPECT_EQ(left.mesh.n_bodies(), 2);
  const auto outlines = find_outlines(left.mesh, CornerRule());
  EXPECT_EQ(outlines.size(), 2);
  // They can be meshed anew.
  EXPECT_EQ(mesh_outlines(outlines, size, 2).mesh.n_bodies(), 2);
}



TEST(RezoningCutOff, SliversAreDropped)
{
  // An element of this size has the area 0.0043.
  const TriangleMesh mesh = mesh_outlines({square(),
                                           square(Point<2>(2., 0.), 0.04),
                                           square(Point<2>(3., 0.), 0.05)},
                                          size,
                                          2)
                              .mesh;
  const auto   masses = masses_of(mesh);
  const CutOff left   = cut_off(mesh, masses, -1., size, 0.5);
  EXPECT_EQ(left.mesh.n_bodies(), 2);
  EXPECT_GT(left.n_cells_sliver, 0);
  EXPECT_EQ(left.n_cells_below, 0);
  EXPECT_NEAR(left.mass_slivers, 1000. * 0.04 * 0.04 * 1.408, 1e-2);
  EXPECT_NEAR(total(masses_of(left.mesh)) + left.mass_slivers,
              total(masses),
              1e-10);
}



// Bodies that touch in a corner share no node afterwards.
TEST(RezoningCutOff, BodiesGetNodesOfTheirOwn)
{
  TriangleMesh mesh;
  mesh.order = 1;
  mesh.nodes = {{0., 0.}, {1., 0.}, {1., 1.}, {2., 1.}, {2., 2.}};
  mesh.cells = {{{0, 1, 2}}, {{2, 3, 4}}};
  find_boundary(mesh, [](unsigned int, unsigned int) {
    return TriangleMesh::free_surface;
  });
  const CutOff left = cut_off(mesh, {1., 1.}, -1., size, 0.5);
  EXPECT_EQ(left.mesh.nodes.size(), 6);
  EXPECT_EQ(left.nodes, std::vector<unsigned int>({0, 1, 2, 2, 3, 4}));
}
