#include <sandglass/base/exceptions.h>
#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/particle_in_cell/particle_splitting.h>
#include <sandglass/output/section_wall_lines.h>
#include <sandglass/output/silo_measures.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/walls/boundary_nodes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh_area.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// A whole section, 1.6 m wide, with the outlet from x = 0 to 0.4 m.
  class WholeSilo : public testing::TestWithParam<std::tuple<CellType, double>>
  {
  protected:
    WholeSilo()
    {
      silo.cell_type           = std::get<0>(GetParam());
      silo.hopper_height       = std::get<1>(GetParam());
      silo.is_symmetric        = false;
      silo.half_width          = 0.8;
      silo.wall_height         = 1.2;
      silo.outlet_half_width   = 0.2;
      silo.outlet_eccentricity = 0.2;
      silo.fall_region_depth   = 0.3;
      silo.element_size        = 0.1;
      silo.check();
    }

    double
    length(const Mesh<2> &mesh, const BoundaryRole role) const
    {
      double length = 0.;
      for (const auto &edge : mesh.faces)
        if (edge.role == role)
          length += mesh.vertices[edge.vertices[0]].distance(
            mesh.vertices[edge.vertices[1]]);
      return length;
    }

    bool
    is_flat() const
    {
      return silo.hopper_height == 0.;
    }

    ClearedParameters cleared;
    SceneParameters   silo;
    WallParameters    walls;
  };
} // namespace



TEST_P(WholeSilo, RolesCoverTheBoundary)
{
  const Mesh<2> mesh   = mesh_silo<2>(silo);
  const double  hopper = silo.hopper_height * 1.6 - // rectangle less triangles
                        silo.hopper_height * (0.8 + 0.4) / 2.;
  EXPECT_NEAR(area(mesh, true), 1.6 * 1.2 + hopper, 1e-12);
  EXPECT_NEAR(area(mesh, false), 0.4 * 0.3, 1e-12);

  EXPECT_EQ(length(mesh, BoundaryRole::axis), 0.);
  EXPECT_NEAR(length(mesh, BoundaryRole::wall), 2.4, 1e-12);
  EXPECT_NEAR(length(mesh, BoundaryRole::outlet), 0.4, 1e-12);
  EXPECT_NEAR(length(mesh, BoundaryRole::top), 1.6, 1e-12);
  EXPECT_NEAR(length(mesh, BoundaryRole::fall_side), 0.6, 1e-12);
  EXPECT_NEAR(length(mesh, BoundaryRole::fall_bottom), 0.4, 1e-12);
  EXPECT_NEAR(length(mesh, BoundaryRole::floor), is_flat() ? 1.2 : 0., 1e-12);
  const double e = silo.hopper_height;
  EXPECT_NEAR(length(mesh, BoundaryRole::hopper),
              is_flat() ? 0. : std::hypot(e, 0.8) + std::hypot(e, 0.4),
              1e-12);
}



TEST_P(WholeSilo, LipsAndCornersOnBothSides)
{
  const Scene<2> scene(mesh_silo<2>(silo),
                       WallParameters(),
                       silo.formulation,
                       4,
                       silo.gravity_vector<2>(),
                       MPI_COMM_WORLD);
  EXPECT_EQ(scene.symmetry_factor, 1.);

  walls.outlet_lip     = WallParameters::OutletLip::floor;
  unsigned int n_fixed = 0, n_corners = 0;
  for (const auto &node : find_boundary_nodes(
         scene.dof_handler, scene.formulation, scene.walls, walls))
    {
      const bool is_lip = std::abs(node.position[1]) < 1e-12 &&
                          std::abs(node.position[0] - 0.2) < 0.2 + 1e-12;
      EXPECT_EQ(node.is_outlet_lip, is_lip);
      if (is_lip)
        {
          EXPECT_NEAR(std::abs(node.position[0] - 0.2), 0.2, 1e-12);
        }
      n_fixed += node.is_fixed;
      n_corners += node.supports.size() == 2;
      for (const auto &support : node.supports)
        {
          // The middle of the material.
          const Tensor<1, 2> outwards = node.position - Point<2>(0.1, 0.6);
          EXPECT_GT(support.normal * outwards, 0.);
        }
    }
  EXPECT_EQ(n_corners, 2);
  EXPECT_EQ(n_fixed, is_flat() ? 2 : 0);

  const SiloMeasures measures(scene);
  EXPECT_NEAR(measures.outlet_width, 0.4, 1e-12);
  EXPECT_NEAR(measures.bottom_centre[0], 0.2, 1e-12);
}



TEST_P(WholeSilo, SidesOfTheWalls)
{
  const Scene<2>  scene(mesh_silo<2>(silo),
                       WallParameters(),
                       silo.formulation,
                       4,
                       silo.gravity_vector<2>(),
                       MPI_COMM_WORLD);
  const WallLines lines(scene.mesh,
                        scene.walls,
                        SiloMeasures<2>(scene).bottom_centre);
  const auto      expect_place = [&](const BoundaryRole    role,
                                const Point<2>       &point,
                                const WallLines::Side side,
                                const double          arc_length) {
    unsigned int vertex = 0;
    while (scene.mesh.vertices[vertex].distance(point) > 1e-9)
      ++vertex;
    const auto &place =
      lines.find(boundary_part(scene.walls, boundary_id(role)).wall, vertex);
    EXPECT_EQ(place.side, side);
    EXPECT_NEAR(place.arc_length, arc_length, 1e-12);
  };
  using Side          = WallLines::Side;
  const double e      = silo.hopper_height;
  const auto   bottom = is_flat() ? BoundaryRole::floor : BoundaryRole::hopper;
  const Point<2> left_foot(-0.8, e), right_foot(0.8, e);
  expect_place(bottom, {0., 0.}, Side::left, 0.);
  expect_place(bottom, left_foot, Side::left, std::hypot(0.8, e));
  expect_place(bottom, right_foot, Side::right, std::hypot(0.4, e));
  expect_place(BoundaryRole::wall, left_foot, Side::left, 0.);
  expect_place(BoundaryRole::wall, {-0.8, e + 1.2}, Side::left, 1.2);
  expect_place(BoundaryRole::wall, right_foot, Side::right, 0.);
  // closed by the static stage
  expect_place(BoundaryRole::outlet, {0., 0.}, Side::middle, 0.);
  expect_place(BoundaryRole::outlet, {0.4, 0.}, Side::middle, 0.4);
}



TEST(CentredSilo, ACentredMeshOfQuadrilateralsIsItsOwnImage)
{
  ClearedParameters cleared;
  SceneParameters   silo;
  silo.cell_type    = CellType::quadrilateral;
  silo.is_symmetric = false;
  silo.element_size = 0.1;
  for (const double hopper_height : {0., 0.6})
    {
      silo.hopper_height = hopper_height;
      const Mesh<2> mesh = mesh_silo<2>(silo);
      for (const auto &vertex : mesh.vertices)
        EXPECT_TRUE(std::any_of(
          mesh.vertices.begin(), mesh.vertices.end(), [&](const auto &other) {
            return other.distance(Point<2>(-vertex[0], vertex[1])) < 1e-9;
          }));
    }
}



// Also where it slopes by little or is eccentric.
TEST(Hopper, QuadrilateralsHaveNoAcuteCorners)
{
  ClearedParameters cleared;
  SceneParameters   silo;
  silo.cell_type = CellType::quadrilateral;
  for (const bool is_half : {true, false})
    for (const double height : {0.1014, 0.3, 0.5, 0.65, 1.1})
      {
        silo.is_symmetric        = is_half;
        silo.outlet_eccentricity = is_half ? 0. : 0.1;
        silo.hopper_height       = height;
        const Mesh<2> mesh       = mesh_silo<2>(silo);
        double        largest    = 0.;
        for (const auto &cell : mesh.cells)
          for (unsigned int v = 0; v < 4; ++v)
            {
              const Point<2> corner = mesh.vertices[cell.vertices[v]];
              const auto a = mesh.vertices[cell.vertices[(v + 1) % 4]] - corner;
              const auto b = mesh.vertices[cell.vertices[(v + 3) % 4]] - corner;
              largest =
                std::max(largest, std::abs(a * b) / (a.norm() * b.norm()));
            }
        // At 45 degrees either mesh has corners like this.
        EXPECT_LT(largest, std::cos(40. / 180. * numbers::PI))
          << height << ' ' << is_half;
      }
}



namespace
{
  /// Mean length in m of the edges between two distances from a point.
  double
  mean_edge(const Mesh<2>  &mesh,
            const Point<2> &point,
            const double    from,
            const double    to)
  {
    double       sum = 0.;
    unsigned int n   = 0;
    for (const auto &cell : mesh.cells)
      for (unsigned int v = 0; v < 3; ++v)
        {
          const auto  &a        = mesh.vertices[cell.vertices[v]];
          const auto  &b        = mesh.vertices[cell.vertices[(v + 1) % 3]];
          const double distance = point.distance((a + b) / 2.);
          if (distance > from && distance < to)
            {
              sum += a.distance(b);
              ++n;
            }
        }
    return sum / n;
  }
} // namespace



TEST(GradedSilo, CellsGrowFromTheLips)
{
  ClearedParameters cleared;
  SceneParameters   silo;
  silo.element_size        = 0.1;
  silo.outlet_element_size = 0.0125;
  for (const bool is_symmetric : {true, false})
    {
      silo.is_symmetric = is_symmetric;
      silo.check();
      const Mesh<2> mesh = mesh_silo<2>(silo);
      for (const double x : {-0.225, 0.225})
        {
          if (x < 0. && is_symmetric)
            continue;
          const Point<2> lip(x, 0.);
          EXPECT_NEAR(mean_edge(mesh, lip, 0., 0.02) / 0.0125, 1., 0.25);
          EXPECT_NEAR(mean_edge(mesh, lip, 0.15, 0.25) / 0.0525, 1., 0.15);
        }
      EXPECT_NEAR(mean_edge(mesh, {0., 1.4}, 0., 0.5) / 0.1, 1., 0.1);
    }
}



TEST(GradedSilo, TheSameSizeEverywhereIsTheMeshWithoutIt)
{
  ClearedParameters cleared;
  SceneParameters   silo;
  silo.element_size  = 0.1;
  const Mesh<2> mesh = mesh_silo<2>(silo);

  silo.outlet_element_size = silo.element_size;
  const Mesh<2> same       = mesh_silo<2>(silo);
  ASSERT_EQ(mesh.vertices.size(), same.vertices.size());
  for (unsigned int i = 0; i < mesh.vertices.size(); ++i)
    EXPECT_EQ(mesh.vertices[i], same.vertices[i]);
}



TEST(GradedSilo, ParticlesAreSplitThereAndNotElsewhere)
{
  ClearedParameters cleared;
  SceneParameters   silo;
  silo.element_size = 0.1;
  for (const double size : {0., 0.025})
    for (const unsigned int seed : {1, 2, 3})
      {
        silo.outlet_element_size = size;
        silo.mesh_seed           = seed;
        const Scene<2>                         scene(mesh_silo<2>(silo),
                             WallParameters(),
                             silo.formulation,
                             4,
                             silo.gravity_vector<2>(),
                             MPI_COMM_WORLD);
        const CellGeometry<CellType::triangle> geometry(scene);
        const InitialConfiguration<PlaneStrain, CellType::triangle> points(
          scene, geometry);
        EXPECT_EQ(cells_differ_much(scene.mesh, points), size > 0.);
      }
}



INSTANTIATE_TEST_SUITE_P(
  Shapes,
  WholeSilo,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Values(0., 0.6)));
