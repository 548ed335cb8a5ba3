#ifndef sandglass_run_parameter_file_h
#define sandglass_run_parameter_file_h

#include <deal.II/base/parameter_handler.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/run/parameter_lines.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * A parameter file and the settings of the command line, with the place of
   * each entry, so that errors can name file and line.
   */
  class ParameterFile
  {
  public:
    /**
     * Rank 0 reads the file. Collective. Throws InputError if it can't be read
     * or understood, or if a setting isn't of the form Section/Name=value.
     */
    ParameterFile(const std::string              &filename,
                  const std::vector<std::string> &settings,
                  const MPI_Comm                  communicator);

    /// Throws InputError for what isn't declared or doesn't fit its pattern.
    void
    parse(dealii::ParameterHandler &prm) const;

    /// What deserves the user's attention: that the file sets nothing, or sets
    /// what has no effect.
    /// @param prm  into which it has been parsed.
    std::vector<std::string>
    warnings(const dealii::ParameterHandler &prm) const;

    /// Whether the command line sets a parameter.
    bool
    is_on_command_line(const std::string &section,
                       const std::string &name) const;

    /// The error given, with file and line of the parameter to blame.
    InputError
    located(const InputError &error) const;

  private:
    /// A parameter's value or, without a name, the start of a section.
    struct Entry
    {
      std::string section, name, value;
      std::string place; ///< "file:line" or the command line's option
      bool        is_on_command_line = false;
    };

    /// Throws InputError for lines without a meaning.
    void
    scan(const std::vector<ParameterLine> &lines);

    void
    add_setting(const std::string &setting);

    static void
    set_entry(const Entry &entry, dealii::ParameterHandler &prm);

    const std::string  filename;
    std::vector<Entry> entries;
    bool               sets_something;
  };

  /**
   * All declared parameters: as a parameter file (prm), as a table for the
   * documentation (md), or for other programs (json).
   */
  std::string
  print_parameters(const dealii::ParameterHandler &prm,
                   const std::string              &format);
} // namespace Sandglass

#endif
