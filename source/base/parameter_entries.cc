#include <deal.II/base/utilities.h>

#include <sandglass/base/parameter_entries.h>

#include <cmath>
#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  BoundedNumber::BoundedNumber(const double lower,
                               const bool   includes_lower,
                               const double upper,
                               const bool   includes_upper)
    : lower(lower)
    , includes_lower(includes_lower)
    , upper(upper)
    , includes_upper(includes_upper)
  {}



  BoundedNumber
  BoundedNumber::any()
  {
    return {-infinity, false, infinity, false};
  }



  BoundedNumber
  BoundedNumber::greater_than(const double lower)
  {
    return {lower, false, infinity, false};
  }



  BoundedNumber
  BoundedNumber::at_least(const double lower)
  {
    return {lower, true, infinity, false};
  }



  BoundedNumber
  BoundedNumber::between(const double lower, const double upper)
  {
    return {lower, false, upper, false};
  }



  BoundedNumber
  BoundedNumber::at_least_below(const double lower, const double upper)
  {
    return {lower, true, upper, false};
  }



  BoundedNumber
  BoundedNumber::within(const double lower, const double upper)
  {
    return {lower, true, upper, true};
  }



  bool
  BoundedNumber::match(const std::string &text) const
  {
    std::istringstream stream(text);
    double             value;
    if (!(stream >> value) || !(stream >> std::ws).eof())
      return false;
    return std::isfinite(value) &&
           (includes_lower ? value >= lower : value > lower) &&
           (includes_upper ? value <= upper : value < upper);
  }



  std::string
  BoundedNumber::description(const OutputStyle) const
  {
    std::ostringstream text;
    text << "a number";
    if (std::isfinite(lower))
      text << (includes_lower ? " at least " : " greater than ") << lower;
    if (std::isfinite(lower) && std::isfinite(upper))
      text << " and";
    if (std::isfinite(upper))
      text << (includes_upper ? " at most " : " less than ") << upper;
    return text.str();
  }



  std::unique_ptr<Patterns::PatternBase>
  BoundedNumber::clone() const
  {
    return std::unique_ptr<PatternBase>(new BoundedNumber(*this));
  }



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
