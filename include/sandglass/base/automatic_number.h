#ifndef sandglass_base_automatic_number_h
#define sandglass_base_automatic_number_h

#include <sandglass/base/parameter_entries.h>

#include <optional>
#include <string>

namespace Sandglass
{
  /// What a parameter file says where the program is to choose.
  inline constexpr char automatic[] = "auto";

  /// Pattern of a BoundedNumber, or of the word `auto`.
  class AutomaticNumber : public dealii::Patterns::PatternBase
  {
  public:
    explicit AutomaticNumber(const BoundedNumber &number)
      : number(number)
    {}

    bool
    match(const std::string &text) const override;

    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<dealii::Patterns::PatternBase>
    clone() const override;

  private:
    const BoundedNumber number;
  };

  /**
   * Declare a real parameter that is `auto` by default; the variable has no
   * value then.
   *
   * @param bounds  of the number, where one is given.
   * @param unit    of the number; "1" for pure numbers.
   */
  void
  add_automatic_number(dealii::ParameterAcceptor &section,
                       const std::string         &name,
                       std::optional<double>     &variable,
                       const BoundedNumber       &bounds,
                       const std::string         &unit,
                       const std::string         &documentation);
} // namespace Sandglass

#endif
