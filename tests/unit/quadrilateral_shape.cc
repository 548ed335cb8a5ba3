#include <sandglass/particles/cell_shape.h>

#include <gtest/gtest.h>

#include <random>

#include "random_engine.h"

using namespace Sandglass;

namespace
{
  using Shape = CellShape<CellType::quadrilateral>;

  /// A square of 1 cm, the last vertex displaced by `twist` of the edge.
  Shape
  square(const double twist)
  {
    constexpr double              edge = 0.01;
    const std::array<Point<2>, 4> vertices{
      {Point<2>(0.3, -1.),
       Point<2>(0.3 + edge, -1.),
       Point<2>(0.3, -1. + edge),
       Point<2>(0.3 + (1. + twist) * edge, -1. + edge)}};
    return Shape(vertices);
  }
} // namespace



/// From any start in the cell, for rectangles, for those that a mesh generator
/// has rounded, and for distorted cells.
TEST(QuadrilateralShape, finds_reference_coordinates_from_any_start)
{
  auto                                   engine = random_engine();
  std::uniform_real_distribution<double> coordinate(-0.2, 1.2);
  const auto                             draw = [&]() {
    return Point<2>(coordinate(engine), coordinate(engine));
  };
  for (const double twist : {0., 1e-15, 1e-12, 1e-6, 0.1, -0.5})
    for (unsigned int n = 0; n < 100; ++n)
      {
        const Shape    shape    = square(twist);
        const Point<2> expected = draw(), start = draw();
        const auto     found =
          shape.to_reference(Sandglass::components_of<2>(
                               shape.to_real(expected)),
                             Sandglass::components_of<2>(start));
        // Positions of the order of 1 m are rounded to some 1e-14 of the edge.
        for (unsigned int d = 0; d < 2; ++d)
          EXPECT_NEAR(found[d], expected[d], 1e-12) << "twist " << twist;
      }
}



/// What the loop computes without the shape functions' gradients.
TEST(QuadrilateralShape, derivatives_are_those_of_the_shape_functions)
{
  const Shape shape = square(0.3);
  using Pair        = std::array<double, 2>;
  const Pair                point{{0.2, 0.7}};
  const std::array<Pair, 4> values{
    {{{1., -2.}}, {{3., 0.5}}, {{-1., 4.}}, {{2., 2.}}}};
  const Pair force{{3., -5.}};

  const auto of_nodes  = shape.shape_gradients(point);
  const auto gradient  = shape.gradient_of(values, point);
  const auto reference = shape.reference_gradients(point);
  Pair       direction;
  for (unsigned int r = 0; r < 2; ++r)
    direction[r] = force[0] * reference[r][0] + force[1] * reference[r][1];
  const auto along = Shape::derivatives_along(direction, point);

  // The gradients are of the order of 100 / m.
  constexpr double tolerance = 1e-11;
  for (unsigned int d = 0; d < 2; ++d)
    for (unsigned int e = 0; e < 2; ++e)
      {
        double sum = 0.;
        for (unsigned int i = 0; i < 4; ++i)
          sum += values[i][d] * of_nodes[i][e];
        EXPECT_NEAR(gradient[d][e], sum, tolerance);
      }
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_NEAR(along[i],
                force[0] * of_nodes[i][0] + force[1] * of_nodes[i][1],
                tolerance);
}
