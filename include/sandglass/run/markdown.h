#ifndef sandglass_run_markdown_h
#define sandglass_run_markdown_h

#include <string>
#include <vector>

namespace Sandglass
{
  /// A line of a Markdown table.
  inline std::string
  markdown_row(const std::vector<std::string> &cells)
  {
    std::string row = "|";
    for (const std::string &cell : cells)
      {
        row += ' ';
        for (const char character : cell)
          row += character == '|' ? "\\|" : std::string(1, character);
        row += " |";
      }
    return row + '\n';
  }

  /// The first two lines of a Markdown table.
  inline std::string
  markdown_head(const std::vector<std::string> &names)
  {
    std::string line = "|";
    for (unsigned int i = 0; i < names.size(); ++i)
      line += "---|";
    return markdown_row(names) + line + '\n';
  }
} // namespace Sandglass

#endif
