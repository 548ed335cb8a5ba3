#ifndef sandglass_base_parameter_entries_h
#define sandglass_base_parameter_entries_h

#include <deal.II/base/parameter_acceptor.h>

#include <sandglass/base/parameter_patterns.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Sandglass
{
  /// Declare a real parameter; `unit` is "1" for pure numbers.
  void
  add_number(dealii::ParameterAcceptor &section,
             const std::string         &name,
             double                    &variable,
             const BoundedNumber       &bounds,
             const std::string         &unit,
             const std::string         &documentation);

  /// Declare a real parameter that may be left empty, as it is by default.
  void
  add_optional_number(dealii::ParameterAcceptor &section,
                      const std::string         &name,
                      std::optional<double>     &variable,
                      const BoundedNumber       &bounds,
                      const std::string         &unit,
                      const std::string         &documentation);

  /// Declare a real parameter that is `auto` by default; the variable has no
  /// value then.
  void
  add_automatic_number(dealii::ParameterAcceptor &section,
                       const std::string         &name,
                       std::optional<double>     &variable,
                       const BoundedNumber       &bounds,
                       const std::string         &unit,
                       const std::string         &documentation);

  /// Declare a list of numbers by name, by default empty.
  void
  add_named_numbers(dealii::ParameterAcceptor &section,
                    const std::string         &name,
                    NamedNumbers              &variable,
                    const NamedNumbersPattern &pattern,
                    const std::string         &unit,
                    const std::string         &documentation);

  void
  add_integer(dealii::ParameterAcceptor &section,
              const std::string         &name,
              unsigned int              &variable,
              const int                  lower,
              const int                  upper,
              const std::string         &documentation);

  void
  add_flag(dealii::ParameterAcceptor &section,
           const std::string         &name,
           bool                      &variable,
           const std::string         &documentation);

  /// Declare a text parameter that `pattern` restricts.
  void
  add_text(dealii::ParameterAcceptor           &section,
           const std::string                   &name,
           std::string                         &variable,
           const dealii::Patterns::PatternBase &pattern,
           const std::string                   &documentation);

  /// Declare a parameter with named values; `names` pairs each with its value.
  template <typename Value>
  void
  add_selection(dealii::ParameterAcceptor                        &section,
                const std::string                                &name,
                Value                                            &variable,
                const std::vector<std::pair<std::string, Value>> &names,
                const std::string                                &documentation)
  {
    std::string default_name, all_names;
    for (const auto &[value_name, value] : names)
      {
        all_names += (all_names.empty() ? "" : "|") + value_name;
        if (value == variable)
          default_name = value_name;
      }
    auto &prm = section.prm;
    section.enter_my_subsection(prm);
    prm.declare_entry(name,
                      default_name,
                      dealii::Patterns::Selection(all_names),
                      documentation);
    prm.add_action(name, [names, &variable](const std::string &text) {
      for (const auto &[value_name, value] : names)
        if (value_name == text)
          variable = value;
    });
    section.leave_my_subsection(prm);
  }

  /// Set a parameter as a parameter file does.
  template <typename Value>
  void
  set_parameter(const std::string &section,
                const std::string &name,
                const Value       &value)
  {
    auto &prm = dealii::ParameterAcceptor::prm;
    prm.enter_subsection(section);
    prm.set(name, value);
    prm.leave_subsection();
  }
} // namespace Sandglass

#endif
