#include <sandglass/base/exceptions.h>
#include <sandglass/flow/updated_lagrangian/settlement_check.h>

#include <gtest/gtest.h>

#include <sstream>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// A column of 2 m that settles in proportion to the height.
  class Settlement : public testing::Test
  {
  protected:
    Settlement()
    {
      Rectangle rectangle;
      rectangle.upper = Point<2>(1., 2.);
      scene           = std::make_unique<Scene<2>>(rectangle.mesh(),
                                         fixture.walls,
                                         fixture.formulation,
                                         1,
                                         fixture.gravity,
                                         MPI_COMM_SELF);
    }

    /// What is said of a settlement by a share of the height.
    std::string
    said(const double share) const
    {
      StaticState<2> state;
      state.cells.resize(scene->triangulation.n_active_cells());
      for (const auto &cell : scene->triangulation.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          state.cells[cell->active_cell_index()].displacement[v][1] =
            -share * cell->vertex(v)[1];
      std::ostringstream         text;
      dealii::ConditionalOStream log(text);
      check_settlement(state, *scene, fixture.material, log);
      return text.str();
    }

    StageFixture              fixture;
    std::unique_ptr<Scene<2>> scene;
  };
} // namespace



TEST_F(Settlement, AFewPerCentPass)
{
  EXPECT_EQ(said(0.03), "");
}



TEST_F(Settlement, MoreIsDoubtedByModulusAndUnits)
{
  const std::string text = said(0.1);
  for (const std::string part : {"Warning: ",
                                 "settled by 0.2 m, 10 % of its height",
                                 "Young modulus",
                                 " Pa",
                                 "lengths in m"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
}



TEST_F(Settlement, AFifthOfTheHeightIsAnError)
{
  try
    {
      said(0.21);
      ADD_FAILURE() << "accepted";
    }
  catch (const RunError &error)
    {
      EXPECT_NE(std::string(error.what()).find("Young modulus"),
                std::string::npos);
    }
}



// A column in millimetres, and one that is as stiff as sand.
TEST_F(Settlement, SoftMaterialIsDoubtedWhereNoRestIsFound)
{
  EXPECT_EQ(doubt_stiffness(*scene, fixture.material), "");
  fixture.material.young_modulus = 1e4;
  EXPECT_NE(doubt_stiffness(*scene, fixture.material).find("Young modulus"),
            std::string::npos);
}
