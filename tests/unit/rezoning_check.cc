#include <sandglass/flow/updated_lagrangian/motion/check_new_mesh.h>

#include <gtest/gtest.h>

using namespace Sandglass;

namespace
{
  RezoningJumps
  jump_of_area(const double after)
  {
    RezoningJumps jumps;
    jumps.before.area = 1.;
    jumps.after.area  = after;
    return jumps;
  }
} // namespace



// Of a body of many elements no more than a hundredth may come or go.
TEST(RezoningCheck, AreaIsKept)
{
  for (const double change : {-0.009, 0., 0.009})
    EXPECT_NO_THROW(check_area(jump_of_area(1. + change), 0.01));
  for (const double change : {-0.011, 0.011, 0.3})
    EXPECT_THROW(check_area(jump_of_area(1. + change), 0.01), RunError);
}



// The rest of a few elements has no smooth boundary to keep.
TEST(RezoningCheck, SmallBodiesMayChangeByTwoElements)
{
  EXPECT_NO_THROW(check_area(jump_of_area(0.8), 0.5));
  EXPECT_THROW(check_area(jump_of_area(0.77), 0.5), RunError);
}
