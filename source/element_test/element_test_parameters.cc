#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/base/parameter_entries.h>
#include <sandglass/element_test/element_test_parameters.h>
#include <sandglass/output/csv_file.h>

#include <algorithm>
#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    void
    add_initial_stress(ElementTestParameters &section)
    {
      auto              &stress = section.initial_stress;
      std::ostringstream default_text;
      default_text << stress[0] << ", " << stress[1] << ", " << stress[2];
      section.enter_my_subsection(section.prm);
      section.prm.declare_entry(
        "Initial stress",
        default_text.str(),
        Patterns::List(BoundedNumber::at_least(0.), 3, 3),
        "Axial stress, lateral stress, and stress out of the plane (the other "
        "lateral one) at the start, compression positive. Units: Pa.");
      section.prm.add_action(
        "Initial stress", [&stress](const std::string &text) {
          const auto numbers =
            Utilities::string_to_double(Utilities::split_string_list(text));
          std::copy(numbers.begin(), numbers.end(), stress.begin());
        });
      section.leave_my_subsection(section.prm);
    }



    void
    add_path(ElementTestParameters &section)
    {
      using Bounds = BoundedNumber;
      add_selection<ElementTestKind>(
        section,
        "Kind",
        section.kind,
        {{"oedometer", ElementTestKind::oedometer},
         {"triaxial", ElementTestKind::triaxial},
         {"biaxial", ElementTestKind::biaxial},
         {"simple shear", ElementTestKind::simple_shear}},
        "What sandglass --element-test does with the law alone: compress "
        "without lateral strain (oedometer), with both lateral stresses held "
        "(triaxial), with one held and no strain out of the plane (biaxial); or "
        "shear with the axial stress held and no lateral strain (simple shear).");
      add_initial_stress(section);
      add_number(
        section,
        "Axial strain",
        section.axial_strain,
        Bounds::any(),
        "1",
        "Where the test ends: shortening over initial height, negative "
        "for extension; in simple shear the displacement over the "
        "initial height, either way.");
      add_number(section,
                 "Largest axial stress",
                 section.largest_axial_stress,
                 Bounds::at_least(0.),
                 "Pa",
                 "Where the test ends as well, if it gets there before; 0: "
                 "nowhere.");
    }
  } // namespace



  ElementTestParameters::ElementTestParameters()
    : ParameterAcceptor("Element test")
  {
    add_path(*this);
    add_integer(*this,
                "Steps",
                n_steps,
                1,
                10000000,
                "Number of equal steps to the Axial strain; rows of "
                "element_test.csv.");
    add_number(
      *this,
      "Strain rate",
      strain_rate,
      BoundedNumber::greater_than(0.),
      "1/s",
      "Of the Axial strain; it matters to laws that depend on the rate "
      "only, such as mu(I).");
  }



  void
  ElementTestParameters::check() const
  {
    const auto refuse =
      [](const char *name, const double value, const std::string &allowed) {
        throw InputError("Element test", name, to_text(value), allowed);
      };
    if (axial_strain == 0.)
      refuse("Axial strain", 0., "allowed is a number other than 0");
    if (!is_shear() && axial_strain > 0.95)
      refuse("Axial strain",
             axial_strain,
             "allowed is a share of the initial height up to 0.95");
    if (largest_axial_stress == 0.)
      return;
    if (is_shear())
      refuse("Largest axial stress",
             largest_axial_stress,
             "allowed is 0 with Kind = simple shear, which holds the axial "
             "stress");
    if (largest_axial_stress <= initial_stress[0])
      refuse("Largest axial stress",
             largest_axial_stress,
             "allowed is 0 (none), or more than the initial axial stress of " +
               to_text(initial_stress[0]) + " Pa");
  }
} // namespace Sandglass
