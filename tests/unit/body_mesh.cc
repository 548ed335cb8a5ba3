#include <deal.II/grid/tria.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/scene/body_cells.h>
#include <sandglass/scene/body_plan.h>
#include <sandglass/scene/body_plan_steps.h>
#include <sandglass/scene/headroom.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/scene/mesh_cells.h>
#include <sandglass/scene/mesh_outlet.h>
#include <sandglass/scene/triangulate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cleared_parameters.h"

using namespace Sandglass;

namespace
{
  using Silo = SceneParameters;

  /// A silo 1 m wide with an outlet 0.3 m wide.
  struct Kind
  {
    std::string        name;
    Silo::CrossSection cross_section;
    Silo::OutletShape  outlet_shape;
    double             hopper_height;
    double             eccentricity;
  };

  void
  PrintTo(const Kind &kind, std::ostream *out)
  {
    *out << kind.name;
  }

  void
  set(Silo &silo, const CellType cell_type, const Kind &kind)
  {
    silo.formulation         = Formulation::three_dimensions;
    silo.cell_type           = cell_type;
    silo.cross_section       = kind.cross_section;
    silo.outlet_shape        = kind.outlet_shape;
    silo.half_width          = 0.5;
    silo.wall_height         = 0.9;
    silo.hopper_height       = kind.hopper_height;
    silo.outlet_half_width   = 0.15;
    silo.outlet_eccentricity = kind.eccentricity;
    silo.fall_region_depth   = 0.3;
    silo.element_size        = 0.1;
    silo.outlet_element_size = 0.05;
    silo.check();
  }

  double
  area(const Mesh<3> &mesh, const BoundaryRole role)
  {
    double sum = 0.;
    for (const auto &face : mesh.faces)
      if (face.role == role)
        for (unsigned int v = 1; v + 1 < mesh.vertices_per_face(); ++v)
          {
            const auto &a = mesh.vertices[face.vertices[0]];
            sum +=
              dealii::cross_product_3d(mesh.vertices[face.vertices[v]] - a,
                                       mesh.vertices[face.vertices[v + 1]] - a)
                .norm() /
              2.;
          }
    return sum;
  }

  double
  volume(const Mesh<3> &mesh)
  {
    dealii::Triangulation<3> triangulation;
    triangulate(mesh, triangulation);
    double sum = 0.;
    for (const auto &cell : triangulation.active_cell_iterators())
      sum += cell->measure();
    return sum;
  }

  class Bodies : public testing::TestWithParam<std::tuple<CellType, Kind>>
  {
  protected:
    Bodies()
    {
      set(silo, std::get<0>(GetParam()), std::get<1>(GetParam()));
    }

    ClearedParameters cleared;
    Silo              silo;
  };

  const Kind box{"Box",
                 Silo::CrossSection::rectangle,
                 Silo::OutletShape::rectangle,
                 0.,
                 0.};
} // namespace



// Facets inside a circle have up to 2 % less area than the circle.
constexpr double facets = 0.03;

TEST_P(Bodies, HaveTheSilosVolumeAndBoundary)
{
  const SiloBody body(silo);
  const Mesh<3>  mesh  = mesh_silo<3>(silo);
  const double   share = body.meshed_share();
  check_overlap(mesh);
  const double expected = body.filled_volume() + 0.3 * body.outlet.area();
  EXPECT_NEAR(volume(mesh), share * expected, facets * share * expected);

  const auto expect_area = [&](const BoundaryRole role,
                               const double       whole,
                               const double       rounding = facets) {
    EXPECT_NEAR(area(mesh, role),
                share * whole,
                rounding * share * whole + 1e-9)
      << name_of(role);
  };
  expect_area(BoundaryRole::top, body.wall.area());
  const bool is_wedge = body.has_hopper() && body.outlet_is_slot;
  expect_area(BoundaryRole::wall,
              0.9 * body.wall.perimeter() + (is_wedge ? 0.5 * (1. + 0.3) : 0.));
  expect_area(BoundaryRole::outlet, body.outlet.area());
  // Twice as coarse as at the lip.
  expect_area(BoundaryRole::fall_bottom, body.outlet.area(), 4. * facets);
  expect_area(BoundaryRole::fall_side, 0.3 * body.outlet.perimeter());
  expect_area(BoundaryRole::floor,
              body.has_hopper() ? 0. : body.wall.area() - body.outlet.area());
  EXPECT_EQ(area(mesh, BoundaryRole::hopper) > 0., body.has_hopper());
  EXPECT_EQ(area(mesh, BoundaryRole::axis) > 0., share < 1.);
}



TEST_P(Bodies, AreClosed)
{
  const Mesh<3> mesh = mesh_silo<3>(silo);
  Tensor<1, 3>  sum;
  double        all = 0.;
  for (const auto &face : mesh.faces)
    if (face.role != BoundaryRole::outlet)
      for (unsigned int v = 1; v + 1 < mesh.vertices_per_face(); ++v)
        {
          const auto &a = mesh.vertices[face.vertices[0]];
          const auto  of_part =
            dealii::cross_product_3d(mesh.vertices[face.vertices[v]] - a,
                                     mesh.vertices[face.vertices[v + 1]] - a);
          sum += of_part;
          all += of_part.norm();
        }
  EXPECT_LT(sum.norm(), 1e-12 * all);
}



TEST_P(Bodies, AreFinerAtTheLip)
{
  const Mesh<3> mesh    = mesh_silo<3>(silo);
  const auto    outlets = mesh_outlets<3>(mesh);
  ASSERT_EQ(outlets.size(), 1u);
  EXPECT_NEAR(outlets[0].width, 0.3, 5e-3);
  EXPECT_GT(outlets[0].edge_at_lip, 0.02);
  EXPECT_LT(outlets[0].edge_at_lip, 0.075);
}



INSTANTIATE_TEST_SUITE_P(
  Kinds,
  Bodies,
  testing::Combine(testing::Values(CellType::tetrahedron, CellType::hexahedron),
                   testing::Values(box,
                                   Kind{"SlotInABox",
                                        Silo::CrossSection::rectangle,
                                        Silo::OutletShape::slot,
                                        0.,
                                        0.},
                                   Kind{"HoleInABox",
                                        Silo::CrossSection::rectangle,
                                        Silo::OutletShape::circle,
                                        0.,
                                        0.},
                                   Kind{"EccentricBox",
                                        Silo::CrossSection::rectangle,
                                        Silo::OutletShape::rectangle,
                                        0.,
                                        0.2},
                                   Kind{"EccentricHole",
                                        Silo::CrossSection::rectangle,
                                        Silo::OutletShape::circle,
                                        0.,
                                        0.2},
                                   Kind{"Cylinder",
                                        Silo::CrossSection::circle,
                                        Silo::OutletShape::circle,
                                        0.,
                                        0.},
                                   Kind{"EccentricCylinder",
                                        Silo::CrossSection::circle,
                                        Silo::OutletShape::circle,
                                        0.,
                                        0.2},
                                   Kind{"Wedge",
                                        Silo::CrossSection::rectangle,
                                        Silo::OutletShape::slot,
                                        0.5,
                                        0.},
                                   Kind{"Pyramid",
                                        Silo::CrossSection::rectangle,
                                        Silo::OutletShape::rectangle,
                                        0.5,
                                        0.},
                                   Kind{"Cone",
                                        Silo::CrossSection::circle,
                                        Silo::OutletShape::circle,
                                        0.5,
                                        0.},
                                   Kind{"EccentricCone",
                                        Silo::CrossSection::circle,
                                        Silo::OutletShape::circle,
                                        0.5,
                                        0.2},
                                   Kind{"SquareToRound",
                                        Silo::CrossSection::rectangle,
                                        Silo::OutletShape::circle,
                                        0.5,
                                        0.},
                                   Kind{"RoundToSquare",
                                        Silo::CrossSection::circle,
                                        Silo::OutletShape::rectangle,
                                        0.5,
                                        0.})),
  [](const auto &info) {
    return std::get<1>(info.param).name +
           (std::get<0>(info.param) == CellType::tetrahedron ? "OfTetrahedra" :
                                                               "OfHexahedra");
  });



namespace
{
  class BothCells : public testing::TestWithParam<CellType>
  {
  protected:
    ClearedParameters cleared;
    Silo              silo;
  };
} // namespace



TEST_P(BothCells, FillABoxExactly)
{
  set(silo, GetParam(), box);
  const Mesh<3> mesh = mesh_silo<3>(silo);
  EXPECT_NEAR(volume(mesh), (0.9 + 0.3 * 0.09) / 4., 1e-12);
  EXPECT_NEAR(area(mesh, BoundaryRole::floor), (1. - 0.09) / 4., 1e-12);
  EXPECT_NEAR(area(mesh, BoundaryRole::axis), 0.9 + 2. * 0.3 * 0.15, 1e-12);
}



TEST_P(BothCells, AreSymmetricWhereTheUserSays)
{
  using Planes = Silo::SymmetryPlanes;
  for (const auto &[planes, share] :
       std::map<Planes, double>{{Planes::none, 1.},
                                {Planes::x, 0.5},
                                {Planes::z, 0.5},
                                {Planes::automatic, 0.25}})
    {
      silo.chosen_symmetry_planes = planes;
      set(silo, GetParam(), box);
      const Mesh<3> mesh = mesh_silo<3>(silo);
      EXPECT_NEAR(volume(mesh), (0.9 + 0.3 * 0.09) * share, 1e-12);
      EXPECT_NEAR(area(mesh, BoundaryRole::wall), 3.6 * share, 1e-12);
    }
}



TEST_P(BothCells, StayInsideWhereTheOutletIsClosed)
{
  set(silo, GetParam(), box);
  silo.outlet_is_open = false;
  Mesh<3> mesh        = mesh_silo<3>(silo);
  sort_along_curve(mesh);
  EXPECT_NEAR(volume(mesh), 0.9 / 4., 1e-12);
  EXPECT_NEAR(area(mesh, BoundaryRole::outlet), 0.09 / 4., 1e-12);
  EXPECT_EQ(area(mesh, BoundaryRole::fall_side), 0.);
  EXPECT_NEAR(area(mesh, BoundaryRole::axis), 0.9, 1e-12);
  add_headroom(mesh, 0.2);
  EXPECT_NEAR(volume(mesh), 1.1 / 4., 1e-12);
}



// Material ends at its surface, a level or a heap of the same volume, with
// empty cells above it up to the silo's top.
TEST_P(BothCells, EndAtTheMaterialsSurface)
{
  set(silo, GetParam(), box);
  silo.fill_height         = 0.6;
  const double fall_region = 0.3 * 0.09 / 4.;
  EXPECT_NEAR(volume(mesh_silo<3>(silo)), 0.6 / 4. + fall_region, 1e-12);
  silo.surface_slope   = 20.;
  silo.gravity         = {0., -9.81, 0.};
  const Mesh<3> heap   = make_mesh<3>(silo, MPI_COMM_SELF);
  const double  filled = volume(heap) - 0.3 / 4. - fall_region;
  EXPECT_NEAR(filled, 0.6 / 4., 0.005 * 0.6 / 4.);
  double lowest = 1., highest = 0.;
  for (const auto &face : heap.faces)
    if (face.role == BoundaryRole::top)
      for (unsigned int v = 0; v < heap.vertices_per_face(); ++v)
        {
          lowest  = std::min(lowest, heap.vertices[face.vertices[v]][1]);
          highest = std::max(highest, heap.vertices[face.vertices[v]][1]);
        }
  // Slope times the distance of the corner from the middle, less the mean one
  const double slope = std::tan(20. * dealii::numbers::PI / 180.);
  EXPECT_NEAR(lowest, 0.6 - slope * (std::sqrt(0.5) - 0.3826), 1e-3);
  EXPECT_GT(highest, 0.9);
}



TEST_P(BothCells, RefuseASurfaceInTheHopper)
{
  set(silo, GetParam(), box);
  silo.hopper_height = 0.4;
  silo.fill_height   = 0.2;
  EXPECT_THROW(mesh_silo<3>(silo), InputError);
}



TEST_P(BothCells, GetHeadroom)
{
  set(silo, GetParam(), box);
  Mesh<3> mesh = mesh_silo<3>(silo);
  add_headroom(mesh, 0.2);
  check_overlap(mesh);
  EXPECT_NEAR(volume(mesh), (0.9 + 0.2 + 0.3 * 0.09) / 4., 1e-12);
  EXPECT_NEAR(area(mesh, BoundaryRole::wall), 1.1, 1e-12);
  // The old one is the material's surface, the new one the end.
  EXPECT_NEAR(area(mesh, BoundaryRole::top), 0.5, 1e-12);
}



INSTANTIATE_TEST_SUITE_P(CellTypes,
                         BothCells,
                         testing::Values(CellType::tetrahedron,
                                         CellType::hexahedron),
                         [](const auto &info) {
                           return info.param == CellType::tetrahedron ?
                                    "Tetrahedra" :
                                    "Hexahedra";
                         });



TEST(BodyCells, AreTurnedTheRightWayOut)
{
  for (const CellType cell_type : {CellType::tetrahedron, CellType::hexahedron})
    {
      Mesh<3> mesh;
      mesh.cell_type = cell_type;
      for (const double z : {0., 1.})
        for (const auto &[x, y] : {std::pair(0., 0.),
                                   std::pair(1., 0.),
                                   std::pair(1., 1.),
                                   std::pair(0., 1.)})
          mesh.vertices.emplace_back(x, y, z);
      mesh.cells.push_back(cell_type == CellType::hexahedron ?
                             Mesh<3>::Cell{{{4, 5, 6, 7, 0, 1, 2, 3}}, true} :
                             Mesh<3>::Cell{{{0, 3, 1, 4, 0, 0, 0, 0}}, true});
      orient_cells(mesh);
      const auto &v = mesh.cells[0].vertices;
      if (cell_type == CellType::hexahedron)
        EXPECT_EQ(v[0], 0u);
      else
        {
          EXPECT_EQ(v[2], 4u);
          EXPECT_EQ(v[3], 1u);
        }
      mesh.vertices[cell_type == CellType::hexahedron ? 6 : 4] =
        Point<3>(0.1, 0.1, cell_type == CellType::hexahedron ? 0.01 : 0.);
      EXPECT_THROW(orient_cells(mesh), InputError);
    }
}



TEST(BodyCells, ThatOverlapAreRefused)
{
  Mesh<3> mesh;
  mesh.cell_type = CellType::tetrahedron;
  mesh.vertices  = {Point<3>(0, 0, 0),
                    Point<3>(1, 0, 0),
                    Point<3>(0, 1, 0),
                    Point<3>(0, 0, 1),
                    Point<3>(0, 0, 2)};
  mesh.cells     = {{{{0, 1, 2, 3, 0, 0, 0, 0}}, true}};
  check_overlap(mesh);
  mesh.cells.push_back({{{0, 1, 2, 4, 0, 0, 0, 0}}, true});
  EXPECT_THROW(check_overlap(mesh), InputError);
}



TEST(GradedSteps, FillTheLengthAndGrow)
{
  const auto shares = graded_steps(2., 0.05, 0.2);
  EXPECT_EQ(shares.front(), 0.);
  EXPECT_EQ(shares.back(), 1.);
  double last = 0.;
  for (unsigned int i = 1; i < shares.size(); ++i)
    {
      const double step = 2. * (shares[i] - shares[i - 1]);
      EXPECT_GT(step, 0.99 * last);
      EXPECT_LT(step, 0.22);
      if (i > 1)
        {
          EXPECT_LT(step, 1.25 * last);
        }
      last = step;
    }
  EXPECT_NEAR(2. * shares[1], 0.055, 0.01);
  EXPECT_EQ(graded_steps(1., 0.25, 0.25).size(), 5u);
}
