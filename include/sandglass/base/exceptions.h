#ifndef sandglass_base_exceptions_h
#define sandglass_base_exceptions_h

#include <stdexcept>
#include <string>

namespace Sandglass
{
  /**
   * The input was refused. The program ends with exit code 2 and has written
   * nothing.
   *
   * Where one parameter is to blame, name it: the reader of the parameter file
   * then puts the file and the line in front of the message.
   */
  class InputError : public std::runtime_error
  {
  public:
    explicit InputError(const std::string &message,
                        const std::string &section = "",
                        const std::string &name    = "")
      : std::runtime_error(message)
      , section(section)
      , name(name)
    {}

    /**
     * @param section,name  of the parameter, as in the parameter file.
     * @param value         that was refused.
     * @param allowed       what would be accepted instead.
     */
    InputError(const std::string &section,
               const std::string &name,
               const std::string &value,
               const std::string &allowed)
      : std::runtime_error("section '" + section + "', parameter '" + name +
                           "', value '" + value + "': " + allowed)
      , section(section)
      , name(name)
    {}

    /// Empty where no single parameter is to blame.
    const std::string section, name;
  };

  /**
   * The run failed: the message says what went wrong, where, when, and what to
   * try. The program ends with exit code 1 and keeps the results so far.
   */
  class RunError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace Sandglass

#endif
