#include <sandglass/base/parameter_entries.h>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    /// Declare an entry whose text `read` turns into a variable's value.
    template <typename Read>
    void
    add_entry(ParameterAcceptor           &section,
              const std::string           &name,
              const std::string           &default_text,
              const Patterns::PatternBase &pattern,
              const std::string           &documentation,
              const Read                  &read)
    {
      auto &prm = section.prm;
      section.enter_my_subsection(prm);
      prm.declare_entry(name, default_text, pattern, documentation);
      prm.add_action(name, read);
      section.leave_my_subsection(prm);
    }



    /// Declare a number, or by default the word `none` for no value.
    void
    add_number_or_none(ParameterAcceptor     &section,
                       const std::string     &name,
                       std::optional<double> &variable,
                       const BoundedNumber   &bounds,
                       const std::string     &none,
                       const std::string     &unit,
                       const std::string     &documentation)
    {
      const OptionalNumber pattern(bounds, none);
      add_entry(section,
                name,
                none,
                pattern,
                documentation + " Units: " + unit + ".",
                [pattern, &variable](const std::string &text) {
                  variable = pattern.parse(text);
                });
    }
  } // namespace



  void
  add_number(ParameterAcceptor   &section,
             const std::string   &name,
             double              &variable,
             const BoundedNumber &bounds,
             const std::string   &unit,
             const std::string   &documentation)
  {
    section.add_parameter(name,
                          variable,
                          documentation + " Units: " + unit + ".",
                          section.prm,
                          bounds);
  }



  void
  add_optional_number(ParameterAcceptor     &section,
                      const std::string     &name,
                      std::optional<double> &variable,
                      const BoundedNumber   &bounds,
                      const std::string     &unit,
                      const std::string     &documentation)
  {
    add_number_or_none(
      section, name, variable, bounds, "", unit, documentation);
  }



  void
  add_automatic_number(ParameterAcceptor     &section,
                       const std::string     &name,
                       std::optional<double> &variable,
                       const BoundedNumber   &bounds,
                       const std::string     &unit,
                       const std::string     &documentation)
  {
    add_number_or_none(
      section, name, variable, bounds, automatic, unit, documentation);
  }



  void
  add_named_numbers(ParameterAcceptor         &section,
                    const std::string         &name,
                    NamedNumbers              &variable,
                    const NamedNumbersPattern &pattern,
                    const std::string         &unit,
                    const std::string         &documentation)
  {
    add_entry(section,
              name,
              "",
              pattern,
              documentation + " Units: " + unit + ".",
              [pattern, &variable](const std::string &text) {
                variable = pattern.parse(text).value_or(NamedNumbers());
              });
  }



  void
  add_integer(ParameterAcceptor &section,
              const std::string &name,
              unsigned int      &variable,
              const int          lower,
              const int          upper,
              const std::string &documentation)
  {
    section.add_parameter(name,
                          variable,
                          documentation,
                          section.prm,
                          Patterns::Integer(lower, upper));
  }



  void
  add_flag(ParameterAcceptor &section,
           const std::string &name,
           bool              &variable,
           const std::string &documentation)
  {
    section.add_parameter(name, variable, documentation);
  }



  void
  add_text(ParameterAcceptor           &section,
           const std::string           &name,
           std::string                 &variable,
           const Patterns::PatternBase &pattern,
           const std::string           &documentation)
  {
    section.add_parameter(name, variable, documentation, section.prm, pattern);
  }
} // namespace Sandglass
