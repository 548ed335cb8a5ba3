#include <sandglass/base/exceptions.h>
#include <sandglass/scene/fill_surface.h>
#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh_area.h"

using namespace Sandglass;

namespace
{
  /// A silo with free triangles or squares, half or whole.
  class FilledSilo : public testing::TestWithParam<std::tuple<CellType, bool>>
  {
  protected:
    FilledSilo()
    {
      silo.cell_type         = std::get<0>(GetParam());
      silo.is_symmetric      = std::get<1>(GetParam());
      silo.half_width        = 0.8;
      silo.wall_height       = 1.2;
      silo.hopper_height     = 0.4;
      silo.outlet_half_width = 0.3;
      silo.fall_region_depth = 0.3;
      silo.element_size      = 0.1;
    }

    Mesh<2>
    mesh()
    {
      silo.check();
      return make_mesh<2>(silo, MPI_COMM_SELF);
    }

    /// Of the whole section.
    double
    filled_area()
    {
      return area(mesh(), true) * (silo.is_symmetric ? 2. : 1.);
    }

    /// The hopper's part, in m^2.
    static constexpr double hopper_area = 0.4 * (0.8 + 0.3);

    SceneParameters silo;
  };
} // namespace



// A level surface is where it is asked for: the nodes are on it, and the area
// is exact.
TEST_P(FilledSilo, Level)
{
  for (const double level : {0.63, 0.97, 1.24})
    {
      silo.fill_height    = level;
      const Mesh<2> mesh_ = mesh();
      EXPECT_NEAR(area(mesh_, true) * (silo.is_symmetric ? 2. : 1.),
                  hopper_area + 1.6 * (level - 0.4),
                  1e-9)
        << level;
      unsigned int n_surface = 0;
      for (const auto &face : mesh_.faces)
        if (face.role == BoundaryRole::top)
          for (const unsigned int vertex : face.vertices)
            if (mesh_.vertices[vertex][1] < 1.5)
              {
                EXPECT_NEAR(mesh_.vertices[vertex][1], level, 1e-9);
                ++n_surface;
              }
      EXPECT_GT(n_surface, 10u);
    }
}



// In the hopper the surface ends at its inclined wall.
TEST_P(FilledSilo, LevelInHopper)
{
  silo.fill_height   = 0.25;
  const double width = 2. * (0.3 + 0.5 * 0.25 / 0.4);
  EXPECT_NEAR(filled_area(), 0.25 * (0.6 + width) / 2., 2e-3);
}



// A heap has the volume of the level surface, up to the one edge that its apex
// may lie in.
TEST_P(FilledSilo, HeapHasVolumeOfLevel)
{
  silo.fill_height   = 1.1;
  silo.surface_slope = 28.;
  EXPECT_NEAR(filled_area(), hopper_area + 1.6 * 0.7, 3e-3);
}



// All cells stay convex, and none becomes flat.
TEST_P(FilledSilo, CellsKeepShape)
{
  for (const double level : {0.55, 0.66, 0.77, 0.88, 1.})
    {
      silo.fill_height         = level;
      const Mesh<2>      mesh_ = mesh();
      const unsigned int n     = mesh_.vertices_per_cell();
      for (const auto &cell : mesh_.cells)
        for (unsigned int v = 0; v < n; ++v)
          {
            const auto corner = mesh_.vertices[cell.vertices[v]];
            const auto a = mesh_.vertices[cell.vertices[(v + 1) % n]] - corner;
            const auto b =
              mesh_.vertices[cell.vertices[(v + n - 1) % n]] - corner;
            EXPECT_GT(a[0] * b[1] - a[1] * b[0],
                      0.12 * (a.norm_square() + b.norm_square()));
          }
    }
}



// Closed silos have the empty cells above the surface as well.
TEST_P(FilledSilo, Closed)
{
  silo.fill_height    = 0.9;
  silo.outlet_is_open = false;
  const Mesh<2> mesh_ = mesh();
  EXPECT_NEAR(area(mesh_, false) * (silo.is_symmetric ? 2. : 1.),
              1.6 * 0.7,
              1e-9);
}



INSTANTIATE_TEST_SUITE_P(
  Section,
  FilledSilo,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::Bool()));
