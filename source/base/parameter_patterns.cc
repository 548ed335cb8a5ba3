#include <deal.II/base/utilities.h>

#include <sandglass/base/parameter_patterns.h>

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



  bool
  OptionalNumber::is_none(const std::string &text) const
  {
    return Utilities::trim(text) == none;
  }



  std::optional<double>
  OptionalNumber::parse(const std::string &text) const
  {
    if (is_none(text))
      return {};
    return Utilities::string_to_double(text);
  }



  bool
  OptionalNumber::match(const std::string &text) const
  {
    return is_none(text) || number.match(text);
  }



  std::string
  OptionalNumber::description(const OutputStyle style) const
  {
    return (none.empty() ? "nothing" : none) + ", or " +
           number.description(style);
  }



  std::unique_ptr<Patterns::PatternBase>
  OptionalNumber::clone() const
  {
    return std::unique_ptr<PatternBase>(new OptionalNumber(*this));
  }



  std::string
  to_text(const NamedNumbers::value_type &named)
  {
    std::ostringstream text;
    text << named.first << ':';
    for (const double number : named.second)
      text << ' ' << number;
    return text.str();
  }



  std::optional<NamedNumbers>
  NamedNumbersPattern::parse(const std::string &text) const
  {
    NamedNumbers result;
    for (const std::string &entry : Utilities::split_string_list(text, ','))
      {
        const auto colon = entry.rfind(':');
        if (colon == std::string::npos)
          return {};
        std::vector<double> numbers;
        std::istringstream  stream(entry.substr(colon + 1));
        for (std::string word; stream >> word;)
          {
            if (!number.match(word))
              return {};
            numbers.push_back(Utilities::string_to_double(word));
          }
        const std::string name = Utilities::trim(entry.substr(0, colon));
        if (name.empty() || numbers.size() < fewest_numbers ||
            numbers.size() > most_numbers ||
            !result.emplace(name, numbers).second)
          return {};
      }
    return result;
  }



  bool
  NamedNumbersPattern::match(const std::string &text) const
  {
    return parse(text).has_value();
  }



  std::string
  NamedNumbersPattern::description(const OutputStyle style) const
  {
    std::ostringstream text;
    text << "a list 'name: value, name: value' with each name once and for "
            "each name ";
    if (fewest_numbers < most_numbers)
      text << fewest_numbers << " to ";
    if (most_numbers > 1)
      text << most_numbers << " numbers, each ";
    text << number.description(style);
    return text.str();
  }



  std::unique_ptr<Patterns::PatternBase>
  NamedNumbersPattern::clone() const
  {
    return std::unique_ptr<PatternBase>(new NamedNumbersPattern(*this));
  }
} // namespace Sandglass
