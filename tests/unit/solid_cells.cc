#include <sandglass/particles/cell_geometry.h>
#include <sandglass/particles/seeding.h>

#include <gtest/gtest.h>

#include "box_mesh.h"
#include "random_engine.h"

using namespace Sandglass;

namespace
{
  /// A unit cube of 5 x 5 x 5 cubes with displaced vertices: hexahedra have
  /// twisted faces, inside and at the boundary.
  Mesh<3>
  irregular_mesh(const CellType cell_type)
  {
    auto                                   engine = random_engine(5);
    std::uniform_real_distribution<double> shift(-0.03, 0.03);
    Box                                    box;
    box.cell_type = cell_type;
    box.n         = {{5, 5, 5}};
    box.displaced = [&](const Point<3> &point) {
      const double x = shift(engine), y = shift(engine), z = shift(engine);
      return Point<3>(point[0] + x, point[1] + y, point[2] + z);
    };
    return box.mesh();
  }

  template <typename Type>
  class SolidCells : public testing::Test
  {
  protected:
    static constexpr CellType cell_type = Type::value;
    using Geometry                      = CellGeometry<cell_type>;
    using Shape                         = typename Geometry::Shape;
    using Kind                          = typename Geometry::Location::Kind;

    SolidCells()
      : scene(irregular_mesh(cell_type),
              WallParameters(),
              Formulation::three_dimensions,
              8,
              Tensor<1, 3>(),
              MPI_COMM_SELF)
      , geometry(scene)
    {}

    Point<3>
    random_point(const double lower, const double upper)
    {
      std::uniform_real_distribution<double> uniform(lower, upper);
      const double x = uniform(engine), y = uniform(engine),
                   z = uniform(engine);
      return {x, y, z};
    }

    Point<3>
    random_reference_point()
    {
      return Shape::clamp(random_point(0., 1.), 0.01);
    }

    /// All cells that hold the point, by looking at each.
    std::vector<unsigned int>
    cells_with(const Point<3> &point) const
    {
      std::vector<unsigned int> result;
      for (unsigned int cell = 0; cell < geometry.n_cells(); ++cell)
        {
          const auto    &shape     = geometry.shape(cell);
          const Point<3> reference = shape.to_reference(point);
          if (Geometry::is_inside(reference, -Geometry::tolerance) &&
              shape.to_real(reference).distance(point) < 1e-13)
            result.push_back(cell);
        }
      return result;
    }

    Scene<3>     scene;
    Geometry     geometry;
    std::mt19937 engine = random_engine(2);
  };

  using CellTypes = testing::Types<CellTypeTag<CellType::tetrahedron, 3>,
                                   CellTypeTag<CellType::hexahedron, 3>>;
  TYPED_TEST_SUITE(SolidCells, CellTypes);
} // namespace

TYPED_TEST(SolidCells, WalkEndsWhereBruteForceFindsThePoint)
{
  for (unsigned int i = 0; i < 300; ++i)
    {
      const Point<3> point    = this->random_point(0., 1.);
      const auto     expected = this->cells_with(point);
      ASSERT_FALSE(expected.empty()) << point;
      for (unsigned int start = 0; start < this->geometry.n_cells();
           start += this->geometry.n_cells() / 11)
        {
          const auto found = this->geometry.find(point, start);
          ASSERT_EQ(found.kind, TestFixture::Kind::inside) << point;
          EXPECT_EQ(std::count(expected.begin(), expected.end(), found.cell), 1)
            << point << " from cell " << start;
          EXPECT_LT(this->geometry.shape(found.cell)
                      .to_real(found.reference_point)
                      .distance(point),
                    1e-13);
        }
    }
}

TYPED_TEST(SolidCells, WalkToAPointOutsideEndsAtTheSideThatItIsBeyond)
{
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int i = 0; i < 50; ++i)
      {
        Point<3> point   = this->random_point(0.1, 0.9);
        point[d]         = i % 2 == 0 ? -0.02 : 1.02;
        const auto found = this->geometry.find(point, i);
        ASSERT_EQ(found.kind, TestFixture::Kind::outside);
        const BoundaryRole expected = d != 1     ? BoundaryRole::wall :
                                      i % 2 == 0 ? BoundaryRole::floor :
                                                   BoundaryRole::top;
        EXPECT_EQ(found.part.role, expected) << point;
      }
  const auto invalid = this->geometry.find(Point<3>(0., std::nan(""), 0.), 0);
  EXPECT_EQ(invalid.kind, TestFixture::Kind::invalid);
}

// Particles on faces, edges and vertices have a cell as well.
TYPED_TEST(SolidCells, WalkFindsVerticesAndMiddlesOfEdges)
{
  for (const auto &cell : this->scene.triangulation.active_cell_iterators())
    for (const unsigned int line : cell->line_indices())
      for (const Point<3> &point :
           {cell->line(line)->vertex(0), cell->line(line)->center()})
        {
          const auto found = this->geometry.find(point, 0);
          EXPECT_TRUE(
            found.kind == TestFixture::Kind::inside ||
            TestFixture::Geometry::is_inside(found.reference_point, -1e-9))
            << point;
        }
}

TYPED_TEST(SolidCells, ShapeFunctionsGiveLinearFieldsAndTheirGradients)
{
  using Shape = typename TestFixture::Shape;
  for (unsigned int cell = 0; cell < this->geometry.n_cells(); cell += 7)
    {
      const Shape   &shape     = this->geometry.shape(cell);
      const Point<3> place     = this->random_reference_point();
      const auto     values    = Shape::shape_values(place);
      const auto     gradients = shape.shape_gradients(place);
      double         sum       = 0.;
      Point<3>       position;
      Tensor<2, 3>   gradient;
      for (unsigned int i = 0; i < Shape::n_nodes; ++i)
        {
          sum += values[i];
          position += values[i] * shape.node(i);
          for (unsigned int d = 0; d < 3; ++d)
            for (unsigned int e = 0; e < 3; ++e)
              gradient[d][e] += shape.node(i)[d] * gradients[i][e];
        }
      EXPECT_NEAR(sum, 1., 1e-15);
      EXPECT_LT(position.distance(shape.to_real(place)), 1e-15);
      EXPECT_LT((gradient - Tensor<2, 3>(unit_symmetric_tensor<3>())).norm(),
                1e-13);
      EXPECT_LT(shape.to_reference(shape.to_real(place)).distance(place),
                1e-14);
      EXPECT_GT(shape.jacobian(place), 0.);
    }
}

TYPED_TEST(SolidCells, SeedsFillTheCellsEvenly)
{
  using Shape = typename TestFixture::Shape;
  for (const unsigned int n : {1u, 8u, 27u})
    {
      const auto points = seed_points<TestFixture::cell_type>(n);
      ASSERT_EQ(points.size(), n);
      Point<3> mean;
      for (unsigned int i = 0; i < n; ++i)
        {
          EXPECT_TRUE(TestFixture::Geometry::is_inside(points[i], 0.01));
          mean += points[i] / static_cast<double>(n);
          for (unsigned int j = 0; j < i; ++j)
            EXPECT_GT(points[i].distance(points[j]), 0.3 / std::cbrt(n));
        }
      const double middle =
        TestFixture::cell_type == CellType::tetrahedron ? 0.25 : 0.5;
      EXPECT_LT(mean.distance(Point<3>(middle, middle, middle)), 1e-14);
    }
  // The parts' volumes add up to the cells'.
  double     volume = 0.;
  const auto points = seed_points<TestFixture::cell_type>(8);
  for (unsigned int cell = 0; cell < this->geometry.n_cells(); ++cell)
    for (const Point<3> &point : points)
      volume += this->geometry.shape(cell).jacobian(point) *
                Shape::reference_area / points.size();
  EXPECT_NEAR(volume, 1., 2e-3);
}

TYPED_TEST(SolidCells, ClampedPointsAreInside)
{
  using Shape = typename TestFixture::Shape;
  for (unsigned int i = 0; i < 100; ++i)
    {
      const Point<3> point   = this->random_point(-1., 2.);
      const Point<3> clamped = Shape::clamp(point, 1e-12);
      EXPECT_TRUE(TestFixture::Geometry::is_inside(clamped, 0.9e-12));
    }
}

TEST(HexahedronShape, DerivativesAlongADirectionAreThoseOfTheGradients)
{
  using Shape = CellShape<CellType::hexahedron>;
  auto                                   engine = random_engine(3);
  std::uniform_real_distribution<double> shift(-0.1, 0.1);
  std::array<Point<3>, 8>                vertices;
  for (unsigned int v = 0; v < 8; ++v)
    for (unsigned int d = 0; d < 3; ++d)
      vertices[v][d] = (v >> d & 1u) + shift(engine);
  const Shape                 shape(vertices);
  const std::array<double, 3> place{{0.3, 0.6, 0.2}};
  const auto                  gradients = shape.shape_gradients(place);

  std::array<std::array<double, 3>, 8> v;
  for (auto &of_node : v)
    for (double &component : of_node)
      component = shift(engine);
  const auto gradient = shape.gradient_of(v, place);
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int e = 0; e < 3; ++e)
      {
        double expected = 0.;
        for (unsigned int i = 0; i < 8; ++i)
          expected += v[i][d] * gradients[i][e];
        EXPECT_NEAR(gradient[d][e], expected, 1e-14);
      }
}
