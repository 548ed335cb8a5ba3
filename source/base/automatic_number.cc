#include <deal.II/base/utilities.h>

#include <sandglass/base/automatic_number.h>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    bool
    is_automatic(const std::string &text)
    {
      return Utilities::trim(text) == automatic;
    }
  } // namespace



  bool
  AutomaticNumber::match(const std::string &text) const
  {
    return is_automatic(text) || number.match(text);
  }



  std::string
  AutomaticNumber::description(const OutputStyle style) const
  {
    return automatic + (", or " + number.description(style));
  }



  std::unique_ptr<Patterns::PatternBase>
  AutomaticNumber::clone() const
  {
    return std::unique_ptr<PatternBase>(new AutomaticNumber(*this));
  }



  void
  add_automatic_number(ParameterAcceptor     &section,
                       const std::string     &name,
                       std::optional<double> &variable,
                       const BoundedNumber   &bounds,
                       const std::string     &unit,
                       const std::string     &documentation)
  {
    auto &prm = section.prm;
    section.enter_my_subsection(prm);
    prm.declare_entry(name,
                      automatic,
                      AutomaticNumber(bounds),
                      documentation + " Units: " + unit + ".");
    prm.add_action(name, [&variable](const std::string &text) {
      variable.reset();
      if (!is_automatic(text))
        variable = Utilities::string_to_double(text);
    });
    section.leave_my_subsection(prm);
  }
} // namespace Sandglass
