// Limit load of a rigid strip footing on cohesive material without weight, by
// the quadratic elements of the state at rest.

#include <sandglass/continuum/plane_strain.h>
#include <sandglass/flow/updated_lagrangian/filled_grid.h>
#include <sandglass/flow/updated_lagrangian/material_equilibrium.h>
#include <sandglass/flow/updated_lagrangian/newton_solver.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <type_traits>

#include "associated_drucker_prager.h"
#include "cleared_parameters.h"
#include "element_choice.h"
#include "prescribed_displacement.h"
#include "rectangle_mesh.h"

using namespace Sandglass;

namespace
{
  /// Half of a strip footing. Elements grow away from its edge, where the
  /// pressure jumps.
  template <typename Law>
  class RigidFooting
  {
  public:
    /// @param friction_angle  that acts in plane flow, in degrees.
    /// @param n_cells         in the footing's half width.
    RigidFooting(const double       friction_angle,
                 const bool         is_rough,
                 const unsigned int n_cells)
      : scene(mesh(n_cells),
              walls,
              Formulation::plane_strain,
              4,
              unit_weight,
              MPI_COMM_SELF)
      , grid(scene, 2)
      , equilibrium(grid, Law(material(friction_angle)), 1., unit_weight)
      , supports(grid, equilibrium.confined_modulus())
      , solver(grid, equilibrium, supports, parameters)
      , displacement(grid.make_vector())
    {
      set_supports(is_rough);
    }

    /**
     * Press until the load hardly grows any more.
     *
     * @param settlement  over the half width, so many times the cohesion over
     *                    Young's modulus.
     * @return N_c, the mean pressure over the cohesion.
     */
    double
    limit(const double settlement)
    {
      constexpr double step     = 2.; // of the settlement, in the same measure
      double           pressure = 0., last = 0.;
      for (double done = 0.; done < settlement; done += step)
        {
          last     = pressure;
          pressure = press(step * cohesion / young_modulus * half_width);
        }
      EXPECT_LT(pressure, 1.001 * last);
      return pressure;
    }

  private:
    static constexpr double half_width = 1., width = 9., depth = 4.; // m
    /// So stiff that the geometry stays.
    static constexpr double cohesion = 1., young_modulus = 1e6; // Pa
    static constexpr double growth = 1.15; // from element to element

    /// No share of it acts; residuals are relative to it.
    const Tensor<1, 2> unit_weight{{0., -1.}};

    double
    press(const double by)
    {
      supports.settlement += by;
      DisplacementVector increment = grid.make_vector();
      EXPECT_TRUE(
        solver.solve(displacement, 0., {100, 30}, increment).has_converged);
      displacement.zero_out_ghost_values();
      displacement.add(1., increment);
      displacement.update_ghost_values();
      equilibrium.start_step();
      return supports.load() / (half_width * cohesion);
    }

    static MaterialConstants
    material(const double friction_angle)
    {
      MaterialConstants constants;
      constants.young_modulus           = young_modulus;
      constants.yield_cone              = YieldCone::plane_strain;
      constants.internal_friction_angle = friction_angle;
      constants.cohesion                = cohesion;
      return constants;
    }

    /// That so many elements fill, in sizes of the first.
    static double
    distance(const double n)
    {
      return (std::pow(growth, n) - 1.) / (growth - 1.);
    }

    static unsigned int
    n_elements_in(const double distance)
    {
      return std::ceil(std::log1p(distance * (growth - 1.)) / std::log(growth));
    }

    static Mesh<2>
    mesh(const unsigned int n_cells)
    {
      const double n = n_cells, h = half_width / distance(n);
      Rectangle    rectangle;
      rectangle.n_x   = n_cells + n_elements_in((width - half_width) / h);
      rectangle.n_y   = n_elements_in(depth / h);
      rectangle.upper = Point<2>(rectangle.n_x, rectangle.n_y);
      Mesh<2> result  = rectangle.mesh();
      for (Point<2> &vertex : result.vertices)
        {
          const double i = vertex[0] - n;
          vertex[0] = half_width + std::copysign(h * distance(std::abs(i)), i);
          vertex[1] = -h * distance(rectangle.n_y - vertex[1]);
        }
      return result;
    }

    /// Smooth sides, a bottom that holds, and the footing.
    void
    set_supports(const bool is_rough)
    {
      constexpr double rounding = 1e-9;
      Point<2>         corner; // right, bottom
      for_each_node(grid, [&](const Point<2> &p, const auto &) {
        corner = Point<2>(std::max(corner[0], p[0]), std::min(corner[1], p[1]));
      });
      for_each_node(grid, [&](const Point<2> &p, const auto &dofs) {
        const bool is_bottom =
          p[1]<corner[1] + rounding, is_pressed = p[1]> - rounding &&
          p[0] < half_width + rounding;
        if (p[0] < rounding || p[0] > corner[0] - rounding || is_bottom ||
            (is_pressed && is_rough))
          supports.hold(dofs[0], 0);
        if (is_bottom)
          supports.hold(dofs[0], 1);
        if (is_pressed)
          supports.press(dofs[0]);
      });
    }

    ClearedParameters                     cleared;
    WallParameters                        walls;
    StaticStageParameters                 parameters;
    Scene<2>                              scene;
    FilledGrid<2>                         grid;
    MaterialEquilibrium<PlaneStrain, Law> equilibrium;
    PrescribedDisplacement                supports;
    NewtonSolver<2>                       solver;
    DisplacementVector                    displacement;
  };

  /// Prandtl's N_c = (N_q - 1) cot(phi), for associated flow.
  double
  exact_limit(const double friction_angle)
  {
    if (friction_angle == 0.)
      return 2. + numbers::PI;
    const double phi  = radians(friction_angle);
    const double sine = std::sin(phi), slope = std::tan(phi);
    return (std::exp(numbers::PI * slope) * (1. + sine) / (1. - sine) - 1.) /
           slope;
  }

  template <typename Law>
  void
  expect_limit(const double       friction_angle,
               const bool         is_rough,
               const unsigned int n_cells,
               const double       settlement)
  {
    const double found =
      RigidFooting<Law>(friction_angle, is_rough, n_cells).limit(settlement);
    const double exact = exact_limit(friction_angle);
    std::cout << (is_rough ? "rough" : "smooth") << " footing, "
              << (std::is_same_v<Law, DruckerPrager> ? "isochoric" :
                                                       "associated")
              << " flow, " << friction_angle << " degrees, " << n_cells
              << " cells: N_c " << found << ", exact " << exact << std::endl;
    EXPECT_NEAR(found / exact, 1., 0.03);
  }
} // namespace



// A weightless material doesn't feel whether the footing is rough.
TEST(RigidFooting, CarriesPrandtlsLoadWithoutFriction)
{
  for (const bool is_rough : {false, true})
    expect_limit<DruckerPrager>(0., is_rough, 10, 60.);
}



// Flow that keeps the volume may carry less than associated flow, by Davis'
// estimate 2 % at this angle.
TEST(RigidFooting, CarriesNearlyPrandtlsLoadWithIsochoricFlow)
{
  expect_limit<DruckerPrager>(10., false, 6, 90.);
}



TEST(RigidFooting, CarriesPrandtlsLoadWithAssociatedFlow)
{
  for (const bool is_rough : {false, true})
    expect_limit<AssociatedDruckerPrager>(25., is_rough, 8, 110.);
}
