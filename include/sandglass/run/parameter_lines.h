#ifndef sandglass_run_parameter_lines_h
#define sandglass_run_parameter_lines_h

#include <string>
#include <vector>

namespace Sandglass
{
  /// A line of a parameter file without its comment, and with the lines that
  /// go on with it after a `\`.
  struct ParameterLine
  {
    std::string text;
    std::string place; ///< "file:line" of its start

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &text &place;
    }
  };

  /**
   * The lines of a parameter file, with those of other files where an `include`
   * asks for them, by a path relative to the file that it stands in. Any ends
   * of lines (Unix, Windows, old Macintosh) and UTF-8 or UTF-16 are read. Lines
   * that are empty are left out.
   *
   * A `#` begins a comment, unless it is inside a word, as in `mesh#2.msh`.
   *
   * Throws InputError if a file can't be read.
   */
  std::vector<ParameterLine>
  read_parameter_lines(const std::string &filename);
} // namespace Sandglass

#endif
