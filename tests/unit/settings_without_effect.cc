#include <sandglass/run/settings_without_effect.h>

#include <gtest/gtest.h>

using namespace Sandglass;

namespace
{
  class SettingsWithoutEffect : public testing::Test
  {
  protected:
    SettingsWithoutEffect()
    {
      declare("Feed", "Kind", "none");
      declare("Feed", "Rate", "0");
      declare("Feed", "Start time", "0");
      declare("Flow", "Method", "particle-in-cell");
      declare("Updated Lagrangian stage", "Time step", "0.01");
    }

    void
    declare(const std::string &section,
            const std::string &name,
            const std::string &value)
    {
      prm.enter_subsection(section);
      prm.declare_entry(name, value);
      prm.leave_subsection();
    }

    void
    set(const std::string &section,
        const std::string &name,
        const std::string &value)
    {
      prm.enter_subsection(section);
      prm.set(name, value);
      prm.leave_subsection();
    }

    dealii::ParameterHandler prm;
  };
} // namespace



TEST_F(SettingsWithoutEffect, AreNamedWithWhatTheyTake)
{
  EXPECT_TRUE(settings_without_effect(prm).empty());
  set("Feed", "Rate", "5");
  const auto warnings = settings_without_effect(prm);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "Feed/Rate = 5 has no effect: it takes Feed/Kind = rain.");
  set("Feed", "Kind", "level");
  EXPECT_EQ(settings_without_effect(prm).size(), 1u);
  set("Feed", "Kind", "rain");
  EXPECT_TRUE(settings_without_effect(prm).empty());
}



// A value that is the default, as in the parameters.prm of a run, says nothing.
TEST_F(SettingsWithoutEffect, AreNotDefaults)
{
  set("Updated Lagrangian stage", "Time step", "0.01");
  set("Feed", "Start time", "0");
  EXPECT_TRUE(settings_without_effect(prm).empty());
  set("Updated Lagrangian stage", "Time step", "0.02");
  ASSERT_EQ(settings_without_effect(prm).size(), 1u);
  EXPECT_NE(settings_without_effect(prm)[0].find("Flow/Method = updated"),
            std::string::npos);
}
