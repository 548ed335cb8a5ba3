#include <sandglass/base/exceptions.h>

#include <gtest/gtest.h>

#include "stage_fixture.h"

using namespace Sandglass;

TEST(TimeStepParameter, ReadsNumbersAndTables)
{
  StageFixture fixture;
  auto        &parameters = fixture.parameters;

  parameters.time_step_text = "2.5e-4";
  parameters.check();
  ASSERT_EQ(parameters.time_steps.size(), 1u);
  EXPECT_EQ(parameters.time_steps[0], std::make_pair(0., 2.5e-4));

  parameters.time_step_text = "0: 2.5e-4, 2: 1.25e-4";
  parameters.check();
  ASSERT_EQ(parameters.time_steps.size(), 2u);
  EXPECT_EQ(parameters.time_steps[1], std::make_pair(2., 1.25e-4));
  EXPECT_FALSE(parameters.has_automatic_time_step);

  parameters.time_step_text = "auto";
  parameters.check();
  EXPECT_TRUE(parameters.has_automatic_time_step);
}

TEST(TimeStepParameter, RefusesWhatMakesNoSense)
{
  StageFixture fixture;
  for (const std::string text : {"",
                                 "fast",
                                 "0",
                                 "-1e-3",
                                 "1e-3 s",
                                 "1: 1e-3",
                                 "0: 1e-3, 0: 1e-4",
                                 "0: 1e-3, 2",
                                 "0: 1e-3, 1: 0"})
    {
      fixture.parameters.time_step_text = text;
      EXPECT_THROW(fixture.parameters.check(), InputError) << text;
    }
}

TEST(TimeStepParameter, TheTableIsFollowedAndTheEndIsMet)
{
  StageFixture fixture;
  fixture.parameters.time_step_text = "0: 1e-3, 0.01: 4e-4";
  fixture.parameters.end_time       = 0.0125;
  Rectangle rectangle;
  rectangle.is_filled = [](const Point<2> &center) { return center[1] > 0.5; };
  auto               &stage = fixture.start(rectangle.mesh());
  std::vector<double> steps;
  while (!stage.is_finished())
    {
      stage.step();
      steps.push_back(stage.view().clock().time_step);
    }
  ASSERT_EQ(steps.size(), 17u);
  for (unsigned int i = 0; i < 10; ++i)
    EXPECT_EQ(steps[i], 1e-3);
  for (unsigned int i = 10; i < 16; ++i)
    EXPECT_EQ(steps[i], 4e-4);
  EXPECT_NEAR(steps[16], 1e-4, 1e-15);
  EXPECT_DOUBLE_EQ(stage.view().clock().time, 0.0125);
}
