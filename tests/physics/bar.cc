#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double h = 0.1; // m

  /// Denser than unstressed, so that no wave separates the particles.
  constexpr double volume_ratio = 0.99;

  /**
   * The elastic bar of the paper's Section 4.3: a row of elements with two rows
   * of particles that move alike, held at both ends and in its depth, which is
   * large, so that shearing of one row past the other does not matter. A
   * pressure that is much larger than the waves' keeps it elastic.
   */
  class Bar
  {
  public:
    /// @param positions  of an element's particles in its length, 0 to 1; in
    /// the
    ///                   bar's right half counted from the right.
    Bar(const unsigned int           n_elements,
        const std::array<double, 2> &positions,
        const double                 consistent_mass_share,
        const double                 relative_time_step)
      : length(n_elements * h)
    {
      fixture.material.poisson_ratio           = 0.;
      fixture.parameters.consistent_mass_share = consistent_mass_share;
      fixture.parameters.end_time              = 1e3;
      // The closed forms' method.
      fixture.parameters.volumetric_strain = VolumetricStrain::element;
      fixture.parameters.force_integration = ForceIntegration::particles;
      fixture.gravity                      = {};
      fixture.walls.normal_condition =
        WallParameters::NormalCondition::acceleration;
      wave_speed = fixture.elasticity().wave_speed(fixture.material.density /
                                                   volume_ratio);
      fixture.set_time_step(relative_time_step * h / wave_speed);

      Rectangle rectangle;
      rectangle.cell_type = CellType::quadrilateral;
      rectangle.n_x       = n_elements;
      rectangle.n_y       = 1;
      rectangle.upper     = Point<2>(length, 100. * h);
      rectangle.left = rectangle.right = BoundaryRole::axis;
      rectangle.bottom = rectangle.top = BoundaryRole::axis;
      fixture.start(rectangle.mesh());
      place(positions);
    }

    /// Set the velocity along the bar to v(x) in m/s.
    template <typename Function>
    void
    set_velocity(const Function &velocity)
    {
      fixture.change_particles([&](auto, const auto &point, auto state) {
        state[StageLayout::velocity] = velocity(point[0]);
      });
    }

    /// The sum of all particles' velocities, each times weight(x).
    template <typename Function>
    double
    velocity(const Function &weight) const
    {
      double sum = 0.;
      fixture.for_each_particle([&](auto, const auto &point, auto state) {
        sum += weight(point[0]) * state[StageLayout::velocity];
      });
      return sum;
    }

    const double length;     ///< in m
    double       wave_speed; ///< in m/s
    StageFixture fixture;

  private:
    void
    place(const std::array<double, 2> &positions)
    {
      const auto &mesh = fixture.scene->mesh;
      fixture.stage->start_from(
        [&](const unsigned int cell, const Point<2> &reference) {
          double center = 0.;
          for (const unsigned int vertex : mesh.cells[cell].vertices)
            center += mesh.vertices[vertex][0] / 4.;
          const bool   is_left = center < length / 2.;
          const double position =
            is_left == (reference[0] < 0.5) ? positions[0] : positions[1];
          InitialState<2> state{{}, {}, volume_ratio};
          state.displacement[0] =
            h * ((is_left ? position : 1. - position) - reference[0]);
          state.stress << -50., -50., -50., 0.; // Pa
          return state;
        },
        {});
    }
  };



  struct Case
  {
    std::array<double, 2> positions;
    double                consistent_mass_share;
  };

  void
  PrintTo(const Case &bar_case, std::ostream *out)
  {
    *out << bar_case.positions[0] << '_' << bar_case.positions[1] << "_share_"
         << bar_case.consistent_mass_share;
  }

  /**
   * The bar's critical step, times wave speed over element size, where only the
   * middle node of two elements moves: 2 m / sqrt(m_c sum M) with m_c = sum M
   * xi^2 and m = alpha m_c + (1 - alpha) sum M xi. With alpha = 1 it is the
   * paper's eq. 17 for the consistent mass matrix; with alpha = 0 the velocity
   * map of eq. 18 makes it larger than eq. 17's for the lumped one.
   */
  double
  predicted_step(const Case &bar_case)
  {
    const auto [a, b]       = bar_case.positions;
    const double consistent = (a * a + b * b) / 2., lumped = (a + b) / 2.;
    const double alpha = bar_case.consistent_mass_share;
    return 2. * (alpha * consistent + (1. - alpha) * lumped) /
           std::sqrt(consistent);
  }

  /// Whether a wave of no size grows a thousandfold in 400 steps.
  bool
  is_unstable(const Case &bar_case, const double relative_time_step)
  {
    Bar          bar(2,
            bar_case.positions,
            bar_case.consistent_mass_share,
            relative_time_step);
    const double start = 1e-10 * bar.wave_speed;
    bar.set_velocity([start](double) { return start; });
    for (unsigned int step = 0; step < 400; ++step)
      {
        bar.fixture.stage->step();
        if (bar.fixture.stage->view().totals().largest_speed > 1e3 * start)
          return true;
      }
    return false;
  }

  class BarStability : public testing::TestWithParam<Case>
  {};
} // namespace



TEST_P(BarStability, EndsAtThePredictedStep)
{
  const double critical = predicted_step(GetParam());
  EXPECT_FALSE(is_unstable(GetParam(), 0.995 * critical));
  EXPECT_TRUE(is_unstable(GetParam(), 1.01 * critical));

  Bar bar(2, GetParam().positions, GetParam().consistent_mass_share, critical);
  EXPECT_NEAR(bar.fixture.stage->view().critical_time_step(true) *
                bar.wave_speed / h / critical,
              1.,
              0.02);
}

INSTANTIATE_TEST_SUITE_P(Bars,
                         BarStability,
                         testing::Values(Case{{{0.25, 0.75}}, 0.},
                                         Case{{{0.5, 0.5}}, 0.},
                                         Case{{{0.02, 0.03}}, 0.},
                                         Case{{{0.1, 0.9}}, 0.},
                                         Case{{{0.25, 0.75}}, 0.5},
                                         Case{{{0.05, 0.3}}, 0.5},
                                         Case{{{0.25, 0.75}}, 0.999999},
                                         Case{{{0.1, 0.2}}, 0.999999},
                                         Case{{{0.6, 0.95}}, 0.999999}));



namespace
{
  /// Measured over exact frequency of the bar's first mode, from the second
  /// zero of its velocity.
  double
  relative_frequency(const unsigned int n_elements, const double share)
  {
    Bar        bar(n_elements, {{0.25, 0.75}}, share, 0.05);
    const auto mode = [&bar](const double x) {
      return std::sin(dealii::numbers::PI * x / bar.length);
    };
    bar.set_velocity(
      [&](const double x) { return 1e-6 * bar.wave_speed * mode(x); });
    auto        &stage  = *bar.fixture.stage;
    unsigned int n_zero = 0;
    double       before = bar.velocity(mode), time = 0.;
    while (n_zero < 2)
      {
        stage.step();
        // The particles' velocities belong to the middle of the step.
        const double now = bar.velocity(mode);
        if (before * now <= 0.)
          {
            ++n_zero;
            time = stage.view().clock().time + stage.view().clock().time_step *
                                                 (now / (before - now) - 0.5);
          }
        before = now;
      }
    // v = cos(omega t) is zero for the second time at 3 pi / 2.
    const double exact = dealii::numbers::PI * bar.wave_speed / bar.length;
    return 1.5 * dealii::numbers::PI / time / exact;
  }
} // namespace



// With the lumped matrix and the velocity map of eq. 18 a mode moves as if its
// mass were M_I M^-1 M_I, which exceeds M_I as much as M_I exceeds M, so that
// its frequency is too low. A consistent share makes that error smaller; it
// costs a linear solver and a shorter step.
TEST(Bar, FrequencyConvergesAndGainsByAConsistentMassShare)
{
  std::array<std::array<double, 3>, 2> errors; // alpha = 0, 1/2; meshes
  for (const unsigned int alpha : {0u, 1u})
    for (const unsigned int mesh : {0u, 1u, 2u})
      errors[alpha][mesh] = relative_frequency(8u << mesh, 0.5 * alpha) - 1.;
  for (const auto &row : errors)
    std::cout << "errors of the frequency with 8, 16, 32 elements " << row[0]
              << ' ' << row[1] << ' ' << row[2] << std::endl;

  EXPECT_NEAR(std::log2(errors[0][1] / errors[0][2]), 2., 0.15);
  for (const unsigned int mesh : {0u, 1u, 2u})
    EXPECT_LT(std::abs(errors[1][mesh]), 0.5 * std::abs(errors[0][mesh]));
}
