#include <sandglass/output/beverloo.h>
#include <sandglass/output/flow_rate.h>
#include <sandglass/output/janssen.h>
#include <sandglass/output/schedule.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace Sandglass;

namespace
{
  // The outlets of the paper's plane and axisymmetric silos, with rates worked
  // out by hand for g = 9.8 m/s^2.
  TEST(Beverloo, plane_outlet_of_the_paper)
  {
    const auto rate = [](const double grain_size) {
      return beverloo_flow_rate(
        Formulation::plane_strain, 1500., 9.8, 0.45, grain_size);
    };
    EXPECT_NEAR(rate(0.0), 1503., 0.5);
    EXPECT_NEAR(rate(0.1), 1348., 0.5);
    EXPECT_NEAR(rate(0.2), 1199., 0.5);
  }



  TEST(Beverloo, axisymmetric_outlet_of_the_paper)
  {
    const auto rate = [](const double grain_size) {
      return beverloo_flow_rate(
        Formulation::axisymmetric, 1500., 9.8, 0.10, grain_size);
    };
    EXPECT_NEAR(rate(0.0), 8.66, 0.005);
    EXPECT_NEAR(rate(0.1), 5.94, 0.005);
    EXPECT_NEAR(rate(0.2), 3.81, 0.005);
  }



  TEST(Janssen, standard_lateral_pressure_ratio)
  {
    // 1.1 (1 - sin 30 degrees)
    EXPECT_NEAR(Janssen::standard_lateral_pressure_ratio(30.), 0.55, 1e-14);
  }



  TEST(Janssen, pressure_at_characteristic_depth)
  {
    // z0 = r / (K mu) = 5 m; p_h = gamma K z0 (1 - 1/e) at z = z0
    const Janssen janssen{15000., 1., 0.5, 0.4};
    const double  expected = 15000. * 0.5 * 5. * (1. - std::exp(-1.));
    EXPECT_NEAR(janssen.horizontal_pressure(5.), expected, 1e-9 * expected);
    EXPECT_NEAR(janssen.vertical_pressure(5.), expected / 0.5, 1e-9 * expected);
  }



  TEST(Janssen, walls_carry_all_further_weight_far_below)
  {
    // mu p_h U = gamma A
    const Janssen janssen{15000., 0.7, 0.5, 0.4};
    EXPECT_NEAR(0.4 * janssen.horizontal_pressure(1000.) / 0.7, 15000., 1e-8);
  }



  TEST(Janssen, hydrostatic_without_friction)
  {
    const Janssen janssen{15000., 1., 0.5, 0.};
    EXPECT_DOUBLE_EQ(janssen.horizontal_pressure(2.), 15000.);
    // and almost so with little friction
    const Janssen rough{15000., 1., 0.5, 1e-12};
    EXPECT_NEAR(rough.horizontal_pressure(2.), 15000., 1e-6);
  }



  TEST(FlowRate, mean_over_window)
  {
    FlowRate flow_rate(0.1);
    EXPECT_EQ(flow_rate.current(), 0.);
    for (int i = 0; i <= 100; ++i)
      {
        const double time = 0.01 * i;
        flow_rate.add(time, 50. * time * time);
        // (50 t^2 - 50 s^2) / (t - s) with s = t - 0.1, at first s = 0
        EXPECT_NEAR(flow_rate.current(),
                    50. * (time + std::max(0., time - 0.1)),
                    1e-9);
      }
  }



  TEST(FlowRate, samples_farther_apart_than_the_window)
  {
    FlowRate flow_rate(0.1);
    flow_rate.add(0., 0.);
    flow_rate.add(1., 2.);
    flow_rate.add(2., 7.);
    EXPECT_DOUBLE_EQ(flow_rate.current(), 5.);
  }



  TEST(FlowRate, mean_between_times_is_by_interpolated_masses)
  {
    FlowRate flow_rate(0.1);
    EXPECT_TRUE(std::isnan(flow_rate.mean(0., 1.)));
    flow_rate.add(0., 0.);
    flow_rate.add(1., 2.);
    flow_rate.add(2., 7.);
    EXPECT_DOUBLE_EQ(flow_rate.mean(0., 2.), 3.5);
    EXPECT_DOUBLE_EQ(flow_rate.mean(0.5, 1.5), 4.5 - 1.);
    EXPECT_NEAR(flow_rate.mean(1., 2. * (1. + 1e-12)), 5., 1e-9);
    EXPECT_TRUE(std::isnan(flow_rate.mean(1., 2.1)));
    EXPECT_TRUE(std::isnan(flow_rate.mean(-0.1, 1.)));
  }



  TEST(FlowRate, plateau_is_mean_over_middle_half_of_mass)
  {
    // Slow, then 100 kg/s while the mass goes from 10 to 90 kg, then slow.
    FlowRate flow_rate(0.1);
    EXPECT_TRUE(std::isnan(flow_rate.plateau()));
    flow_rate.add(0., 0.);
    EXPECT_TRUE(std::isnan(flow_rate.plateau()));
    flow_rate.add(1., 10.);
    flow_rate.add(1.8, 90.);
    flow_rate.add(3., 100.);
    EXPECT_NEAR(flow_rate.plateau(), 100., 1e-9);
  }



  TEST(FlowRate, steady_flow_is_the_longest_stretch_of_nearly_equal_rates)
  {
    FlowRate flow_rate(0.1);
    EXPECT_TRUE(std::isnan(flow_rate.steady().rate));
    // 100 kg/s for 0.5 s, 8 % above and below 200 kg/s in turn for 1 s, 150
    // kg/s for 0.3 s, then nothing for 2 s
    double mass = 0.;
    flow_rate.add(0., mass);
    EXPECT_TRUE(std::isnan(flow_rate.steady().rate));
    for (int i = 1; i <= 38; ++i)
      {
        const double rate = i <= 5  ? 100. :
                            i <= 15 ? (i % 2 == 0 ? 184. : 216.) :
                            i <= 18 ? 150. :
                                      0.;
        mass += 0.1 * rate;
        flow_rate.add(0.1 * i, mass);
      }
    const SteadyFlow steady = flow_rate.steady();
    EXPECT_NEAR(steady.start, 0.5, 1e-12);
    EXPECT_NEAR(steady.end, 1.5, 1e-12);
    EXPECT_NEAR(steady.rate, 200., 1e-9);
  }



  TEST(FlowRate, steady_flow_of_a_slow_decline_is_within_ten_percent)
  {
    // Rate 100 (1 - t) kg/s: all stretches from r to r 9/11 are as steady as is
    // allowed, the first lasts longest.
    FlowRate flow_rate(0.001);
    for (int i = 0; i <= 1000; ++i)
      {
        const double time = 0.001 * i;
        flow_rate.add(time, 100. * (time - time * time / 2.));
      }
    const SteadyFlow steady = flow_rate.steady();
    EXPECT_EQ(steady.start, 0.);
    EXPECT_NEAR(steady.end, 2. / 11., 0.002);
    EXPECT_NEAR(steady.rate, 100. * 10. / 11., 0.2);
  }



  TEST(FlowRate, discharge_time_is_known_once_the_flow_has_ended)
  {
    // 100 kg/s for 2 s, then nothing: 99.9 % of it at 1.998 s
    FlowRate flow_rate(0.1);
    EXPECT_TRUE(std::isnan(flow_rate.discharge_time()));
    for (int i = 0; i <= 25; ++i)
      {
        flow_rate.add(0.1 * i, std::min(10. * i, 200.));
        if (i <= 20)
          {
            EXPECT_TRUE(std::isnan(flow_rate.discharge_time())) << i;
          }
        else
          {
            EXPECT_NEAR(flow_rate.discharge_time(), 1.998, 1e-9) << i;
          }
      }
  }



  TEST(Schedule, first_step_at_or_after_each_multiple)
  {
    Schedule     schedule(0.1);
    unsigned int n_due = 0;
    double       time  = 0.;
    // Rounding leaves the sum of the steps a little below the multiples.
    for (unsigned int step = 1; step <= 1000; ++step)
      {
        time += 0.001;
        const bool is_due = schedule.is_due(time);
        EXPECT_EQ(is_due, step % 100 == 0) << step;
        if (is_due)
          {
            schedule.pass(time);
            ++n_due;
          }
      }
    EXPECT_EQ(n_due, 10);
    // A step over several multiples is due once.
    EXPECT_TRUE(schedule.is_due(1.35));
    schedule.pass(1.35);
    EXPECT_FALSE(schedule.is_due(1.39));
    EXPECT_TRUE(schedule.is_due(1.40));
  }



  TEST(Schedule, never_without_interval)
  {
    const Schedule schedule(0.);
    EXPECT_FALSE(schedule.is_due(1e9));
  }
} // namespace
