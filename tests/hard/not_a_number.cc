#include <sandglass/base/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <string>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  struct Disturbance
  {
    std::string  name;
    unsigned int property;
    double       value;
  };

  void
  PrintTo(const Disturbance &disturbance, std::ostream *out)
  {
    *out << disturbance.name << " = " << disturbance.value;
  }

  class NotANumber : public testing::TestWithParam<Disturbance>
  {};
} // namespace



// Stress that is not a number must stay so when it is projected onto the yield
// surface: the out-of-plane one, which no force feels, was set to zero there,
// and the run went on.
TEST_P(NotANumber, InAParticlesStateStopsTheRun)
{
  StageFixture fixture;
  fixture.parameters.end_time = 1e3;
  auto &stage                 = fixture.start(Rectangle().mesh());
  for (unsigned int step = 0; step < 7; ++step)
    stage.step();
  fixture.change_particles([](auto id, auto &, auto state) {
    if (id == 50)
      state[GetParam().property] = GetParam().value;
  });

  std::string message;
  try
    {
      for (unsigned int step = 0; step < 3; ++step)
        stage.step();
    }
  catch (const RunError &error) // exit code 1
    {
      message = error.what();
    }
  std::cout << message << std::endl;
  for (const char *part :
       {"Step ", "article ", "last in cell ", "not a number", "Try"})
    EXPECT_NE(message.find(part), std::string::npos) << part;
}

namespace
{
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity     = std::numeric_limits<double>::infinity();
} // namespace

INSTANTIATE_TEST_SUITE_P(
  States,
  NotANumber,
  testing::Values(
    Disturbance{"mass", StageLayout::mass, not_a_number},
    Disturbance{"velocity", StageLayout::velocity + 1, not_a_number},
    Disturbance{"stress_xx", StageLayout::stress, not_a_number},
    Disturbance{"stress_zz", StageLayout::stress + Component::zz, not_a_number},
    Disturbance{"stress_xy", StageLayout::stress + Component::xy, not_a_number},
    Disturbance{"density", StageLayout::density, not_a_number},
    Disturbance{"velocity_infinite", StageLayout::velocity, infinity},
    Disturbance{"stress_infinite", StageLayout::stress + 1, -infinity},
    Disturbance{"density_zero", StageLayout::density, 0.}));
