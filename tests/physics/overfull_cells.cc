#include <gtest/gtest.h>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// A closed box half full of sand, with twice the mass in the cells of a
  /// corner at the bottom.
  class OverfullCorner : public testing::TestWithParam<CellType>
  {
  protected:
    /// The corner's mass at the end over that of as much sand.
    double
    share_after(const double duration, const RelieveOverfullCells when)
    {
      StageFixture fixture;
      fixture.parameters.end_time               = duration;
      fixture.parameters.relieve_overfull_cells = when;
      Rectangle rectangle;
      rectangle.cell_type = GetParam();
      rectangle.n_x = rectangle.n_y = 8;
      rectangle.is_filled           = [](const Point<2> &center) {
        return center[1] < 0.5;
      };
      const auto is_in_corner = [](const Point<2> &position) {
        return position[0] > 0.75 && position[1] < 0.25;
      };
      auto &stage = fixture.start(rectangle.mesh());
      fixture.change_particles([&](auto, const auto &position, auto state) {
        if (is_in_corner(position))
          state[StageLayout::mass] *= 2.;
      });
      const double mass = mass_of_all(stage.view().totals());
      while (!stage.is_finished())
        stage.step();

      EXPECT_NEAR(mass_of_all(stage.view().totals()) / mass, 1., 1e-12);
      double in_corner = 0.;
      fixture.for_each_particle([&](auto, const auto &position, auto state) {
        if (is_in_corner(position))
          in_corner += state[StageLayout::mass];
      });
      return in_corner / (fixture.material.density * 0.25 * 0.25);
    }
  };
} // namespace



// Pressure drives out what is too much; without it the corner stays as full as
// it is.
TEST_P(OverfullCorner, IsRelieved)
{
  constexpr double duration = 6.; // s
  EXPECT_GT(share_after(duration, RelieveOverfullCells::never), 1.7);
  const double share = share_after(duration, RelieveOverfullCells::always);
  EXPECT_LT(share, 1.25);
  EXPECT_GT(share, 0.9);
}



INSTANTIATE_TEST_SUITE_P(Cells,
                         OverfullCorner,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
