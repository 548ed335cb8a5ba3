#include <sandglass/particles/cell_geometry.h>

#include <gtest/gtest.h>

#include "random_engine.h"
#include "rectangle_mesh.h"

using namespace Sandglass;

namespace
{
  /// A unit square of 12 x 12 squares with displaced vertices.
  Mesh<2>
  irregular_mesh(const CellType cell_type)
  {
    auto                                   engine = random_engine(5);
    std::uniform_real_distribution<double> shift(-0.02, 0.02);
    Rectangle                              rectangle;
    rectangle.cell_type = cell_type;
    rectangle.n_x = rectangle.n_y = 12;
    rectangle.displaced           = [&](const Point<2> &point) {
      const double x = shift(engine), y = shift(engine);
      return Point<2>(point[0] + x, point[1] + y);
    };
    return rectangle.mesh();
  }

  template <typename Type>
  class CellWalk : public testing::Test
  {
  protected:
    static constexpr CellType cell_type = Type::value;
    using Geometry                      = CellGeometry<cell_type>;
    using Kind                          = typename Geometry::Location::Kind;

    CellWalk()
      : scene(irregular_mesh(cell_type),
              WallParameters(),
              Formulation::plane_strain,
              4,
              Tensor<1, 2>(),
              MPI_COMM_SELF)
      , geometry(scene)
    {}

    /// All cells that hold the point, by looking at each.
    std::vector<unsigned int>
    cells_with(const Point<2> &point) const
    {
      std::vector<unsigned int> result;
      for (unsigned int cell = 0; cell < geometry.n_cells(); ++cell)
        {
          // Far from a quadrilateral its reference coordinates don't exist.
          const auto    &shape     = geometry.shape(cell);
          const Point<2> reference = shape.to_reference(point);
          if (Geometry::is_inside(reference, -Geometry::tolerance) &&
              shape.to_real(reference).distance(point) < 1e-13)
            result.push_back(cell);
        }
      return result;
    }

    /// The walk from each of some cells ends in a cell that has the point.
    void
    check(const Point<2> &point) const
    {
      const auto expected = cells_with(point);
      ASSERT_FALSE(expected.empty()) << point;
      for (unsigned int start = 0; start < geometry.n_cells(); start += 37)
        {
          const auto found = geometry.find(point, start);
          ASSERT_EQ(found.kind, Kind::inside) << point;
          EXPECT_EQ(std::count(expected.begin(), expected.end(), found.cell), 1)
            << point << " from cell " << start;
          EXPECT_LT(geometry.shape(found.cell)
                      .to_real(found.reference_point)
                      .distance(point),
                    1e-13);
        }
      // A particle that is already in a cell with the point stays there.
      for (const unsigned int cell : expected)
        EXPECT_EQ(geometry.find(point, cell).cell, cell) << point;
    }

    const Scene<2> scene;
    const Geometry geometry;
  };

  using CellTypes =
    testing::Types<std::integral_constant<CellType, CellType::triangle>,
                   std::integral_constant<CellType, CellType::quadrilateral>>;
} // namespace

TYPED_TEST_SUITE(CellWalk, CellTypes);

TYPED_TEST(CellWalk, FindsRandomPoints)
{
  auto                                   engine = random_engine(7);
  std::uniform_real_distribution<double> coordinate(0., 1.);
  for (unsigned int i = 0; i < 500; ++i)
    {
      const double x = coordinate(engine), y = coordinate(engine);
      this->check(Point<2>(x, y));
    }
}

TYPED_TEST(CellWalk, FindsPointsOnVerticesAndEdges)
{
  for (const auto &vertex : this->scene.mesh.vertices)
    this->check(vertex);
  for (const auto &face : this->scene.triangulation.active_face_iterators())
    this->check(face->center());
}

TYPED_TEST(CellWalk, NamesTheBoundaryThatAPointIsBeyond)
{
  const auto expect = [this](const Point<2> &point, const BoundaryRole role) {
    const auto found = this->geometry.find(point, 40);
    ASSERT_EQ(found.kind, std::decay_t<decltype(found)>::Kind::outside);
    EXPECT_EQ(found.part.role, role) << point;
  };
  expect({-0.01, 0.5}, BoundaryRole::axis);
  expect({1.01, 0.5}, BoundaryRole::wall);
  expect({0.5, -0.01}, BoundaryRole::floor);
  expect({0.5, 1.01}, BoundaryRole::top);
}

TYPED_TEST(CellWalk, RejectsWhatIsNotANumber)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(this->geometry.find({nan, 0.5}, 3).kind,
            std::decay_t<decltype(this->geometry)>::Location::Kind::invalid);
}
