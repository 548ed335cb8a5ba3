#include <sandglass/base/exceptions.h>
#include <sandglass/scene/gates.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/scene/mesh_faces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mesh_area.h"
#include "rectangle_mesh.h"

using namespace Sandglass;

namespace
{
  struct Gate : GateParameters
  {
    explicit Gate(const std::vector<double> &numbers)
    {
      openings["outlet"] = numbers;
    }
  };

  /// A whole section of squares, its outlet eight of them wide.
  Mesh<2>
  silo()
  {
    SceneParameters parameters;
    parameters.cell_type         = CellType::quadrilateral;
    parameters.is_symmetric      = false;
    parameters.half_width        = 0.8;
    parameters.wall_height       = 1.;
    parameters.outlet_half_width = 0.4;
    parameters.fall_region_depth = 0.3;
    parameters.element_size      = 0.1;
    return mesh_silo<2>(parameters);
  }

  /// Faces at the boundary between material and nothing, by their role.
  unsigned int
  n_boundary_faces(const Mesh<2> &mesh, const BoundaryRole role)
  {
    const auto   cells_at = cells_at_faces(mesh);
    unsigned int n        = 0;
    for (const auto &face : mesh.faces)
      if (face.role == role)
        n += cells_at.at(key_of<2>(face.vertices, 2)).size() == 1 ? 1 : 0;
    return n;
  }
} // namespace



// Shares between the times given are linear, before and behind them constant.
TEST(Gates, ShareOverTime)
{
  const Gate parameters({1., 20., 3., 100., 3., 50.});
  EXPECT_DOUBLE_EQ(parameters.open_share("outlet", 0.), 0.2);
  EXPECT_DOUBLE_EQ(parameters.open_share("outlet", 2.), 0.6);
  EXPECT_DOUBLE_EQ(parameters.open_share("outlet", 3.), 0.5);
  EXPECT_DOUBLE_EQ(parameters.open_share("outlet", 9.), 0.5);
  EXPECT_DOUBLE_EQ(parameters.open_share("another", 0.), 1.);
}



// Closed faces are walls; the fall region below them ends there, and nothing
// else changes. A part that is open is not a boundary at all.
TEST(Gates, ClosedFacesAreWalls)
{
  const Mesh<2> open = silo();
  for (const double share : {0., 50., 100.})
    {
      const Gate         parameters({0., share});
      const Gates<2>     gates(open, parameters);
      const auto         closed = gates.closed_at(0.);
      const unsigned int n_closed =
        std::count(closed.begin(), closed.end(), true);
      EXPECT_EQ(n_closed, 8 * (1. - share / 100.));
      const Mesh<2> mesh = gates.close(closed);
      EXPECT_EQ(n_boundary_faces(mesh, BoundaryRole::outlet), n_closed);
      EXPECT_EQ(n_boundary_faces(mesh, BoundaryRole::fall_side),
                n_boundary_faces(open, BoundaryRole::fall_side) + n_closed);
      EXPECT_NEAR(area(mesh, true), area(open, true), 1e-12);
      EXPECT_NEAR(area(mesh, false), area(open, false), 1e-12);
      // Each side of a closed gate has a vertex of its own but for those on the
      // gate's edge.
      EXPECT_EQ(mesh.vertices.size() - open.vertices.size(),
                share == 0.  ? 9u :
                share == 50. ? 4u :
                               0u);
      // Every boundary face has a name.
      const auto           cells_at = cells_at_faces(mesh);
      std::set<FaceKey<2>> named;
      for (const auto &face : mesh.faces)
        named.insert(key_of<2>(face.vertices, 2));
      for (const auto &[face, cells] : cells_at)
        EXPECT_TRUE(cells.size() > 1 || named.count(face) == 1);
    }
}



// A gate opens from where it is told to.
TEST(Gates, OpensFrom)
{
  using OpensFrom     = GateParameters::OpensFrom;
  const Mesh<2> open  = silo();
  const auto    range = [&](const OpensFrom from) {
    Gate parameters({0., 50.});
    parameters.opens_from = from;
    const Gates<2> gates(open, parameters);
    const auto     closed = gates.closed_at(0.);
    double         left = 1., right = -1.;
    for (unsigned int i = 0; i < open.faces.size(); ++i)
      if (open.faces[i].role == BoundaryRole::outlet && !closed[i])
        for (const unsigned int vertex : open.faces[i].vertices)
          {
            left  = std::min(left, open.vertices[vertex][0]);
            right = std::max(right, open.vertices[vertex][0]);
          }
    return std::make_pair(left, right);
  };
  EXPECT_NEAR(range(OpensFrom::left).first, -0.4, 1e-9);
  EXPECT_NEAR(range(OpensFrom::left).second, 0., 1e-9);
  EXPECT_NEAR(range(OpensFrom::right).first, 0., 1e-9);
  EXPECT_NEAR(range(OpensFrom::right).second, 0.4, 1e-9);
  EXPECT_NEAR(range(OpensFrom::middle).first, -0.2, 1e-9);
  EXPECT_NEAR(range(OpensFrom::middle).second, 0.2, 1e-9);
}



// With half a section the axis goes on below a closed gate.
TEST(Gates, HalfSection)
{
  SceneParameters parameters;
  parameters.half_width        = 0.8;
  parameters.wall_height       = 1.;
  parameters.outlet_half_width = 0.4;
  parameters.fall_region_depth = 0.3;
  parameters.element_size      = 0.1;
  const Mesh<2>  open          = mesh_silo<2>(parameters);
  const Gate     of_gate({0., 0., 1., 100.});
  const Gates<2> gates(open, of_gate);
  const Mesh<2>  closed = gates.close(gates.closed_at(0.));
  EXPECT_EQ(n_boundary_faces(closed, BoundaryRole::axis),
            n_boundary_faces(open, BoundaryRole::axis));
  EXPECT_EQ(n_boundary_faces(closed, BoundaryRole::outlet), 4u);
  const auto half = gates.closed_at(0.5);
  EXPECT_EQ(std::count(half.begin(), half.end(), true), 2);
}
