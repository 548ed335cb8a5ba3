#include <sandglass/base/exceptions.h>
#include <sandglass/run/fingerprint.h>

#include <gtest/gtest.h>

#include "rectangle_mesh.h"

using namespace Sandglass;

namespace
{
  /// Two parameters, one of them in a section that nobody knows yet.
  struct Handler : dealii::ParameterHandler
  {
    Handler(const std::string &size, const std::string &quantity)
    {
      enter_subsection("Scene");
      declare_entry("Element size", size);
      declare_entry("Partitioner", "METIS");
      leave_subsection();
      enter_subsection("Future");
      enter_subsection("Part");
      declare_entry("Quantity", quantity);
      leave_subsection();
      leave_subsection();
    }
  };



  /// Why a run with another fingerprint can't go on; empty if it can.
  std::string
  refusal(const Fingerprint &written, const Fingerprint &now)
  {
    try
      {
        refuse_changes(written, now, "a-file");
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("'a-file'"),
                  std::string::npos);
        return error.section + '/' + error.name + ": " + error.what();
      }
    return "";
  }



  void
  expect_refusal(const std::string &refusal,
                 const std::string &parameter,
                 const std::string &difference)
  {
    EXPECT_EQ(refusal.find(parameter + ": "), 0) << refusal;
    EXPECT_NE(refusal.find(difference), std::string::npos) << refusal;
  }



  const Mesh<2> mesh = Rectangle().mesh();



  TEST(Fingerprint, same_numbers_in_other_words)
  {
    EXPECT_EQ(refusal({Handler("0.1", "1, 2e3"), mesh},
                      {Handler("1e-1", "1,2000"), mesh}),
              "");
  }



  TEST(Fingerprint, any_parameter_is_refused_with_both_values)
  {
    expect_refusal(refusal({Handler("0.1", "1"), mesh},
                           {Handler("0.2", "1"), mesh}),
                   "Scene/Element size",
                   "Scene/Element size = 0.1, and now it is 0.2");
    expect_refusal(refusal({Handler("0.1", "much"), mesh},
                           {Handler("0.1", "more"), mesh}),
                   "Future/Part/Quantity",
                   "Future/Part/Quantity = much, and now it is more");
  }



  TEST(Fingerprint, parameter_of_another_version)
  {
    const Handler handler("0.1", "1");
    Handler       more("0.1", "1");
    more.declare_entry("New", "5");
    expect_refusal(refusal({handler, mesh}, {more, mesh}),
                   "/New",
                   "New = none, by another version of Sandglass, and now it "
                   "is 5");
    expect_refusal(refusal({more, mesh}, {handler, mesh}),
                   "/New",
                   "New = 5, and now it is none");
  }



  TEST(Fingerprint, free_parameter)
  {
    Handler other("0.1", "1");
    other.enter_subsection("Scene");
    other.set("Partitioner", "p4est");
    other.leave_subsection();
    EXPECT_EQ(refusal({Handler("0.1", "1"), mesh}, {other, mesh}), "");
  }



  TEST(Fingerprint, renamed_boundary)
  {
    Mesh<2> renamed = mesh;
    for (auto &face : renamed.faces)
      if (face.role == BoundaryRole::floor)
        face.role = BoundaryRole::hopper;
    const Handler handler("0.1", "1");
    expect_refusal(refusal({handler, mesh}, {handler, renamed}),
                   "Scene/Mesh file",
                   "boundary of Scene/mesh");
  }



  TEST(Fingerprint, other_filling)
  {
    Mesh<2> emptier                 = mesh;
    emptier.cells.front().is_filled = !emptier.cells.front().is_filled;
    const Handler handler("0.1", "1");
    expect_refusal(refusal({handler, mesh}, {handler, emptier}),
                   "Scene/Mesh file",
                   "filled in another way");
  }



  TEST(Fingerprint, moved_vertex)
  {
    Mesh<2> moved = mesh;
    moved.vertices.front()[0] += 1e-12;
    const Handler handler("0.1", "1");
    expect_refusal(refusal({handler, mesh}, {handler, moved}),
                   "Scene/Mesh file",
                   "Scene/mesh = ");
  }
} // namespace
