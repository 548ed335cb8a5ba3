#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../random_engine.h"
#include "../static_fixture.h"

using namespace Sandglass;

namespace
{
  /**
   * Random closed silos of the kinds that Newton's method alone finds no state
   * at rest for: walls as rough as the material or rougher, and boxes, under
   * which it flows. doc/studies/closed_silos.py has more kinds.
   */
  class ClosedSilos : public testing::TestWithParam<unsigned int>
  {
  protected:
    ClosedSilos()
      : engine(random_engine(GetParam()))
    {
      const auto cell_types = {CellType::triangle, CellType::quadrilateral};
      cell_type             = *(cell_types.begin() + GetParam() % 2);
      if (GetParam() / 2 % 2 == 1)
        fixture.formulation = Formulation::axisymmetric;

      const double friction_angle              = draw(5., 45.);
      fixture.material.internal_friction_angle = friction_angle;
      fixture.material.poisson_ratio           = draw(0.2, 0.4);
      fixture.walls.friction_angle             = friction_angle + draw(0., 15.);
    }

    double
    draw(const double least, const double most)
    {
      return std::uniform_real_distribution<double>(least, most)(engine);
    }

    /// A material that its weight strains by 0.0003 to 0.02.
    void
    draw_stiffness(const double height)
    {
      fixture.material.young_modulus = fixture.material.density * 9.81 *
                                       height * std::pow(10., draw(1.7, 3.5));
    }

    std::mt19937  engine;
    StaticFixture fixture;
    CellType      cell_type = CellType::triangle;
  };



  /// A rectangle of this many squares in the half width without those of a box
  /// on the axis, from row `low` up to row `high`.
  Mesh<2>
  mesh_around_box(Rectangle          rectangle,
                  const unsigned int width,
                  const unsigned int low,
                  const unsigned int high)
  {
    const double size   = rectangle.upper[0] / rectangle.n_x;
    rectangle.is_filled = [=](const Point<2> &point) {
      return point[0] > width * size || point[1] < low * size ||
             point[1] > high * size;
    };
    Mesh<2>    mesh   = rectangle.mesh();
    const auto number = [&](const unsigned int i, const unsigned int j) {
      return j * (rectangle.n_x + 1) + i;
    };
    // Not floor and wall: where these meet the default holds the node.
    for (unsigned int i = 0; i < width; ++i)
      for (const unsigned int j : {low, high})
        mesh.faces.push_back(
          {{{number(i, j), number(i + 1, j)}}, BoundaryRole::hopper});
    for (unsigned int j = low; j < high; ++j)
      mesh.faces.push_back(
        {{{number(width, j), number(width, j + 1)}}, BoundaryRole::hopper});
    return filled_part(mesh).mesh;
  }



  /// Whether the state at rest has been found, the walls carry the weight, and
  /// nothing hangs from the box.
  void
  expect_rest(const StaticFixture &fixture)
  {
    std::cout << fixture.log_text.str();
    EXPECT_EQ(fixture.log_text.str().find("Warning"), std::string::npos);
    // Relaxed states are exact to 1e-6 of nodal forces, not of their sum.
    EXPECT_NEAR(fixture.lift() / fixture.weight(), 1., 1e-4);
    for (const WallForce<2> &force : fixture.state.wall_forces)
      {
        const bool is_ceiling = force.normal[1] > 0.5;
        if (is_ceiling)
          {
            EXPECT_GE(force.normal_force(), -1e-9 * fixture.weight())
              << "at " << fixture.position_of(force);
          }
      }
  }
} // namespace



TEST_P(ClosedSilos, WithHopperComesToRest)
{
  SceneParameters &silo  = fixture.silo;
  silo.cell_type         = cell_type;
  silo.formulation       = fixture.formulation;
  silo.half_width        = 1.;
  silo.wall_height       = draw(2., 6.);
  silo.outlet_half_width = draw(0.1, 0.5);
  silo.hopper_height = (1. - silo.outlet_half_width) / std::tan(draw(0.2, 1.4));
  silo.element_size  = 0.08;
  silo.outlet_is_open = false;
  draw_stiffness(silo.wall_height);
  ASSERT_NO_THROW(fixture.run_silo()) << fixture.log_text.str();
  expect_rest(fixture);
}



TEST_P(ClosedSilos, WithBoxComesToRest)
{
  Rectangle rectangle;
  rectangle.cell_type = cell_type;
  rectangle.n_x       = 20;
  rectangle.n_y       = 20 * std::lround(draw(2., 6.));
  rectangle.upper     = Point<2>(1., rectangle.n_y / 20.);

  draw_stiffness(rectangle.upper[1]);
  // At least two cells high, so that no face on the axis keeps its vertices.
  const unsigned int width = std::lround(draw(4., 12.)),
                     low   = std::lround(draw(0.2, 0.4) * rectangle.n_y),
                     high  = low + 2 + std::lround(draw(0., 8.));
  const Mesh<2> mesh       = mesh_around_box(rectangle, width, low, high);
  ASSERT_NO_THROW(fixture.run(mesh)) << fixture.log_text.str();
  expect_rest(fixture);
}



INSTANTIATE_TEST_SUITE_P(Seeds, ClosedSilos, testing::Range(1u, 11u));
