#ifndef sandglass_base_parameter_patterns_h
#define sandglass_base_parameter_patterns_h

#include <deal.II/base/patterns.h>

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * Pattern of a real number between two bounds, each of which may itself be
   * excluded. deal.II's Patterns::Double includes its bounds, which would allow
   * a density of zero or a Poisson ratio of one half.
   */
  class BoundedNumber : public dealii::Patterns::PatternBase
  {
  public:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    static BoundedNumber
    any();
    static BoundedNumber
    greater_than(const double lower);
    static BoundedNumber
    at_least(const double lower);
    /// lower < value < upper
    static BoundedNumber
    between(const double lower, const double upper);
    /// lower <= value < upper
    static BoundedNumber
    at_least_below(const double lower, const double upper);
    /// lower <= value <= upper
    static BoundedNumber
    within(const double lower, const double upper);

    bool
    match(const std::string &text) const override;

    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<dealii::Patterns::PatternBase>
    clone() const override;

  private:
    BoundedNumber(const double lower,
                  const bool   includes_lower,
                  const double upper,
                  const bool   includes_upper);

    double lower;
    bool   includes_lower;
    double upper;
    bool   includes_upper;
  };

  /// What a parameter file says where the program is to choose.
  inline constexpr char automatic[] = "auto";

  /// Pattern of a BoundedNumber, or of a word that stands for none.
  class OptionalNumber : public dealii::Patterns::PatternBase
  {
  public:
    /// @param none  the word; empty for nothing at all.
    explicit OptionalNumber(const BoundedNumber &number,
                            const std::string   &none = "")
      : number(number)
      , none(none)
    {}

    /// The number that a matching text stands for, if any.
    std::optional<double>
    parse(const std::string &text) const;

    bool
    match(const std::string &text) const override;

    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<dealii::Patterns::PatternBase>
    clone() const override;

  private:
    bool
    is_none(const std::string &text) const;

    BoundedNumber number;
    std::string   none;
  };

  /// One or several numbers for each of some names.
  using NamedNumbers = std::map<std::string, std::vector<double>>;

  /// One of them as a parameter file has it: `name: number number`.
  std::string
  to_text(const NamedNumbers::value_type &named);

  /**
   * Pattern of a list `name: number, name: number`, in which each name stands
   * once. Where there are several numbers for a name, spaces are between them.
   * The list may be empty.
   */
  class NamedNumbersPattern : public dealii::Patterns::PatternBase
  {
  public:
    NamedNumbersPattern(const BoundedNumber &number,
                        const unsigned int   fewest_numbers = 1,
                        const unsigned int   most_numbers   = 1)
      : number(number)
      , fewest_numbers(fewest_numbers)
      , most_numbers(most_numbers)
    {}

    /// The list that a matching text stands for; nothing if it doesn't match.
    std::optional<NamedNumbers>
    parse(const std::string &text) const;

    bool
    match(const std::string &text) const override;

    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<dealii::Patterns::PatternBase>
    clone() const override;

  private:
    BoundedNumber number;
    unsigned int  fewest_numbers, most_numbers;
  };
} // namespace Sandglass

#endif
