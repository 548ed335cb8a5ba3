#include <sandglass/base/exceptions.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/scene/mesh_faces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh_area.h"

using namespace Sandglass;

namespace
{
  /// A whole silo whose outlet lies in the middle.
  struct Silo : SceneParameters
  {
    Silo(const CellType cell_type_, const double hopper_height_)
    {
      cell_type         = cell_type_;
      is_symmetric      = false;
      half_width        = 0.8;
      wall_height       = 1.2;
      hopper_height     = hopper_height_;
      outlet_half_width = 0.2;
      fall_region_depth = 0.3;
      element_size      = 0.1;
    }
  };

  /// Largest distance of the surface's nodes from the line that falls from the
  /// middle, in m; the silo's top lies above it.
  double
  distance_from_surface(const Mesh<2> &mesh, const double slope)
  {
    double apex = 0., distance = 0.;
    for (const auto &cell : mesh.cells)
      if (cell.is_filled)
        for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
          {
            const auto &vertex = mesh.vertices[cell.vertices[v]];
            apex = std::max(apex, vertex[1] + slope * std::abs(vertex[0]));
          }
    const auto cells_at = cells_at_faces(mesh);
    for (const auto &face : mesh.faces)
      if (face.role == BoundaryRole::top &&
          cells_at.at(key_of<2>(face.vertices, 2)).size() == 2)
        for (const unsigned int v : face.vertices)
          distance =
            std::max(distance,
                     std::abs(mesh.vertices[v][1] +
                              slope * std::abs(mesh.vertices[v][0]) - apex));
    return distance;
  }

  /// Twice the area of a cell's triangles at its corners over the squares of
  /// their legs: 1 of a square, 0 of a flat cell.
  double
  worst_shape(const Mesh<2> &mesh)
  {
    double             worst = 1.;
    const unsigned int n     = mesh.vertices_per_cell();
    for (const auto &cell : mesh.cells)
      for (unsigned int v = 0; v < n; ++v)
        {
          const auto corner = mesh.vertices[cell.vertices[v]];
          const auto a = mesh.vertices[cell.vertices[(v + 1) % n]] - corner;
          const auto b = mesh.vertices[cell.vertices[(v + n - 1) % n]] - corner;
          worst        = std::min(worst,
                           2. * (a[0] * b[1] - a[1] * b[0]) /
                             (a.norm_square() + b.norm_square()));
        }
    return worst;
  }

  /// Whether each face of the boundary, and each between material and nothing,
  /// has a name.
  bool
  all_have_names(const Mesh<2> &mesh)
  {
    std::set<FaceKey<2>> named;
    for (const auto &face : mesh.faces)
      named.insert(key_of<2>(face.vertices, 2));
    const auto cells_at = cells_at_faces(mesh);
    return std::all_of(cells_at.begin(), cells_at.end(), [&](const auto &of) {
      const auto &[face, cells] = of;
      return named.count(face) > 0 ||
             (cells.size() == 2 &&
              mesh.cells[cells[0]].is_filled == mesh.cells[cells[1]].is_filled);
    });
  }

  class Section : public testing::TestWithParam<CellType>
  {};
} // namespace



// Level surfaces and heaps on flat bottoms, shallow and steep hoppers, with
// their ends on the walls or in the hopper, above outlets in the middle and
// beside it: nodes lie on the surface, cells have areas, faces have names, and
// all of the silo is meshed.
TEST_P(Section, IsCutAlongSurface)
{
  unsigned int n_meshes = 0, n_skew = 0;
  for (const double hopper_height : {0., 0.4, 1.})
    for (const double eccentricity : {0., 0.25, -0.5})
      for (const double slope : {0., 20., 35.})
        for (double level = 0.35; level < 1.2 + hopper_height - 0.35;
             level += 0.127)
          for (const bool is_half : {false, true})
            {
              if (is_half && eccentricity != 0.)
                continue;
              Silo silo(GetParam(), hopper_height);
              silo.is_symmetric        = is_half;
              silo.outlet_eccentricity = eccentricity;
              silo.fill_height         = level;
              silo.surface_slope       = slope;
              SCOPED_TRACE(testing::Message()
                           << "hopper " << hopper_height << ", eccentricity "
                           << eccentricity << ", slope " << slope << ", level "
                           << level << (is_half ? ", half" : ""));
              Mesh<2> mesh;
              try
                {
                  mesh = make_mesh<2>(silo, MPI_COMM_SELF);
                }
              catch (const InputError &error)
                {
                  // The heap of a low level doesn't cover the outlet; and on a
                  // hopper far beside the middle structured cells are skew.
                  if (error.name == "Cell type")
                    ++n_skew;
                  else
                    EXPECT_LT(level, 0.5) << error.what();
                  continue;
                }
              ++n_meshes;
              const double share = is_half ? 0.5 : 1.;
              const double whole =
                1.6 * 1.2 + hopper_height * (0.8 + 0.2) + 2. * 0.2 * 0.3;
              EXPECT_NEAR(area(mesh, true) + area(mesh, false),
                          share * whole,
                          1e-9);
              EXPECT_LT(distance_from_surface(mesh,
                                              std::tan(slope * M_PI / 180.)),
                        1e-9);
              // A heap that ends above the foot of its wall has the volume of
              // the level.
              if (level - 0.4 * std::tan(slope * M_PI / 180.) > hopper_height)
                {
                  EXPECT_NEAR(area(mesh, true),
                              share * (hopper_height * (0.8 + 0.2) +
                                       1.6 * (level - hopper_height)),
                              1e-9);
                }
              EXPECT_GT(worst_shape(mesh), 0.02);
              EXPECT_TRUE(all_have_names(mesh));
            }
  EXPECT_GT(n_meshes, 200u);
  EXPECT_LT(n_skew, 3u);
}



// Layers have levels of their own, which leave the surface where it is.
TEST_P(Section, KeepsSurfaceInLayers)
{
  for (const unsigned int n_layers : {2, 5, 10, 20})
    {
      Silo silo(GetParam(), 0.4);
      silo.fill_height         = 0.9;
      silo.surface_slope       = 30.;
      silo.is_filled_in_layers = true;
      silo.n_layers            = n_layers;
      const Mesh<2> mesh       = make_mesh<2>(silo, MPI_COMM_SELF);
      EXPECT_LT(distance_from_surface(mesh, std::tan(M_PI / 6.)), 1e-9);
      EXPECT_NEAR(area(mesh, true), 0.4 * (0.8 + 0.2) + 1.6 * 0.5, 1e-9);
      EXPECT_GT(worst_shape(mesh), 0.1);
    }
}



// A level that leaves no room for a cell is the section's top.
TEST_P(Section, EndsAtSurfaceNearTop)
{
  Silo silo(GetParam(), 0.4);
  silo.fill_height   = 1.57;
  const Mesh<2> mesh = make_mesh<2>(silo, MPI_COMM_SELF);
  double        top  = 0.;
  for (const auto &vertex : mesh.vertices)
    top = std::max(top, vertex[1]);
  EXPECT_DOUBLE_EQ(top, 1.57);
  EXPECT_NEAR(area(mesh, true), 0.4 * (0.8 + 0.2) + 1.6 * 1.17, 1e-9);
}



// Headroom comes on the silo's top, not on the material's surface.
TEST_P(Section, HasHeadroomAboveItsTop)
{
  Silo silo(GetParam(), 0.);
  silo.fill_height   = 0.7;
  silo.headroom      = 0.2;
  const Mesh<2> mesh = make_mesh<2>(silo, MPI_COMM_SELF);
  EXPECT_NEAR(area(mesh, true), 1.6 * 0.7, 1e-9);
  EXPECT_NEAR(area(mesh, false), 1.6 * (0.5 + 0.2) + 2. * 0.2 * 0.3, 1e-9);
  EXPECT_TRUE(all_have_names(mesh));
}



// What can't be meshed or doesn't stand on the walls is refused by name.
TEST_P(Section, IsRefused)
{
  const auto message = [&](const double level, const double slope) {
    Silo silo(GetParam(), 0.);
    silo.fill_height   = level;
    silo.surface_slope = slope;
    try
      {
        make_mesh<2>(silo, MPI_COMM_SELF);
      }
    catch (const InputError &error)
      {
        EXPECT_EQ(error.name, "Fill height");
        return std::string(error.what());
      }
    return std::string();
  };
  EXPECT_NE(message(0.05, 0.).find("no cell lies below"), std::string::npos);
  EXPECT_NE(message(0.2, 30.).find("must cover the floor"), std::string::npos);
  EXPECT_NE(message(1.1, 30.).find("whose apex is"), std::string::npos);
  EXPECT_NE(message(0.95, 30.).find("half an Element size"), std::string::npos);
  EXPECT_EQ(message(0.9, 30.), "");
}



INSTANTIATE_TEST_SUITE_P(CellTypes,
                         Section,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));



// Graded triangles and those of chosen size meet the surface as well; a low
// level asks for smaller ones, but only down to half the size.
TEST(SectionOfTriangles, GradedAndAutomatic)
{
  Silo silo(CellType::triangle, 0.4);
  silo.fill_height         = 0.9;
  silo.outlet_element_size = 0.02;
  EXPECT_NEAR(area(make_mesh<2>(silo, MPI_COMM_SELF), true),
              0.4 * (0.8 + 0.2) + 1.6 * 0.5,
              1e-9);
  silo.outlet_element_size.reset();
  silo.element_size.reset();
  const double usual = silo.resolution().element_size;
  EXPECT_NEAR(area(make_mesh<2>(silo, MPI_COMM_SELF), true),
              0.4 * (0.8 + 0.2) + 1.6 * 0.5,
              1e-9);
  silo.fill_height = 0.2;
  EXPECT_DOUBLE_EQ(silo.resolution().element_size, usual);
  silo.fill_height = 1e-3;
  EXPECT_DOUBLE_EQ(silo.resolution().element_size, 0.04);
  // Without a flat hopper, which asks for smaller ones in any case.
  silo.hopper_height = 0.;
  silo.fill_height   = 0.9;
  EXPECT_DOUBLE_EQ(silo.resolution().element_size, 0.08);
  silo.fill_height = 0.2;
  EXPECT_DOUBLE_EQ(silo.resolution().element_size, 0.05);
}
