#include <sandglass/scene/make_mesh.h>
#include <sandglass/walls/boundary_nodes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// Silos whose outlet reaches to the wall, or whose hopper reaches to the
  /// top: some of the section's lines are points.
  class SiloLimits : public testing::TestWithParam<std::tuple<CellType, bool>>
  {
  protected:
    SiloLimits()
    {
      silo.cell_type         = std::get<0>(GetParam());
      silo.is_symmetric      = std::get<1>(GetParam());
      silo.half_width        = 0.8;
      silo.wall_height       = 1.2;
      silo.outlet_half_width = 0.4;
      silo.fall_region_depth = 0.3;
      silo.element_size      = 0.1;
    }

    /// The mesh, and a check that it covers this area in m^2 of the whole
    /// section above the outlet.
    Mesh<2>
    mesh_of_area(const double area)
    {
      silo.check();
      const Mesh<2> mesh   = mesh_silo<2>(silo);
      double        filled = 0.;
      for (const auto &cell : mesh.cells)
        for (unsigned int v = 0; v < mesh.vertices_per_cell() && cell.is_filled;
             ++v)
          {
            const auto &a = mesh.vertices[cell.vertices[v]];
            const auto &b =
              mesh.vertices[cell.vertices[(v + 1) % mesh.vertices_per_cell()]];
            filled += (a[0] * b[1] - a[1] * b[0]) / 2.;
          }
      EXPECT_NEAR(filled * (silo.is_symmetric ? 2. : 1.), area, 1e-9);
      return mesh;
    }

    static bool
    has(const Mesh<2> &mesh, const BoundaryRole role)
    {
      return std::any_of(mesh.faces.begin(),
                         mesh.faces.end(),
                         [role](const auto &face) {
                           return face.role == role;
                         });
    }

    /// How many nodes lie where a wall ends at the opening.
    unsigned int
    n_lips(const Mesh<2> &mesh) const
    {
      const Scene<2> scene(mesh,
                           walls,
                           Formulation::plane_strain,
                           1,
                           Tensor<1, 2>({0., -9.81}),
                           MPI_COMM_WORLD);
      const auto     nodes = find_boundary_nodes(scene.dof_handler,
                                             scene.formulation,
                                             scene.walls,
                                             walls);
      return std::count_if(nodes.begin(), nodes.end(), [](const auto &node) {
        return node.is_free && std::abs(node.position[1]) < 1e-12;
      });
    }

    ClearedParameters cleared;
    SceneParameters   silo;
    WallParameters    walls;
  };
} // namespace



TEST_P(SiloLimits, AnOutletAsWideAsTheSiloLeavesNoFloor)
{
  silo.outlet_half_width = silo.half_width;
  const Mesh<2> mesh     = mesh_of_area(1.6 * 1.2);
  EXPECT_FALSE(has(mesh, BoundaryRole::floor));
  EXPECT_TRUE(has(mesh, BoundaryRole::wall));
  EXPECT_EQ(n_lips(mesh), silo.is_symmetric ? 1u : 2u);
}



TEST_P(SiloLimits, AHopperMayReachToTheTop)
{
  silo.hopper_height = 0.6;
  silo.wall_height   = 0.;
  const Mesh<2> mesh = mesh_of_area((1.6 + 0.8) / 2. * 0.6);
  EXPECT_FALSE(has(mesh, BoundaryRole::wall));
  EXPECT_TRUE(has(mesh, BoundaryRole::hopper));
  EXPECT_TRUE(has(mesh, BoundaryRole::top));
  EXPECT_EQ(n_lips(mesh), silo.is_symmetric ? 1u : 2u);
}



TEST_P(SiloLimits, AnEccentricOutletMayTouchOneWall)
{
  if (silo.is_symmetric)
    return;
  for (const double height : {0., 0.6})
    {
      silo.hopper_height       = height;
      silo.outlet_eccentricity = 0.4;
      const Mesh<2> mesh = mesh_of_area(1.6 * 1.2 + (1.6 + 0.8) / 2. * height);
      EXPECT_EQ(n_lips(mesh), 2u);
    }
}



INSTANTIATE_TEST_SUITE_P(
  Shapes,
  SiloLimits,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Bool()));
