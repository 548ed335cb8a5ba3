#include <sandglass/base/exceptions.h>
#include <sandglass/output/replace_file.h>
#include <sandglass/run/checkpoint_files.h>

#include <boost/crc.hpp>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// To be raised whenever what any class writes into archives changes. All
    /// versions begin alike, and end with the checksum of all before it.
    const std::string format        = "Sandglass checkpoint 9\n";
    const std::string any_beginning = "Sandglass checkpoint ";

    using Checksum = std::array<char, 8>;

    /// As hexadecimal digits, which are the same on every machine.
    Checksum
    checksum(const char *const begin, const std::size_t size)
    {
      boost::crc_32_type sum;
      sum.process_bytes(begin, size);
      auto               rest = sum.checksum();
      constexpr unsigned base = 16;
      Checksum           digits;
      for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit)
        {
          *digit = "0123456789abcdef"[rest % base];
          rest /= base;
        }
      return digits;
    }



    [[noreturn]] void
    refuse(const std::string &filename, const std::string &what)
    {
      throw InputError("--restart: '" + filename + "' " + what,
                       "Output",
                       "Directory");
    }



    bool
    has_right_checksum(const std::string &text)
    {
      if (text.size() < format.size() + Checksum().size())
        return false;
      const std::size_t size = text.size() - Checksum().size();
      const Checksum    sum  = checksum(text.data(), size);
      return text.compare(size, sum.size(), sum.data(), sum.size()) == 0;
    }
  } // namespace



  CheckpointFiles::CheckpointFiles(const std::string &directory)
    : last(directory + "/checkpoint.bin")
    , before(directory + "/checkpoint-before.bin")
  {}



  void
  CheckpointFiles::write(const std::string &content) const
  {
    std::string    text = format + content;
    const Checksum sum  = checksum(text.data(), text.size());
    text.append(sum.data(), sum.size());

    // A second name for the last one, so that its first name is never without
    // a file. Where there are none, as on some file systems, only one is kept.
    const std::string second_name = unfinished_name(before);
    std::error_code   none;
    std::filesystem::remove(second_name, none);
    std::filesystem::create_hard_link(last, second_name, none);
    if (!none)
      std::filesystem::rename(second_name, before, none);
    replace_file(last, text, Survives::machine);
  }



  std::string
  read_checkpoint_content(const std::string &filename)
  {
    std::ifstream file(filename, std::ios::binary);
    if (!file || !std::filesystem::is_regular_file(filename))
      refuse(filename, "can't be read");
    std::ostringstream content;
    content << file.rdbuf();
    const std::string text = content.str();
    if (!has_right_checksum(text))
      refuse(filename, "is damaged, or no checkpoint: its checksum is wrong");
    if (text.compare(0, format.size(), format) != 0)
      refuse(filename,
             text.compare(0, any_beginning.size(), any_beginning) == 0 ?
               "is of another version of Sandglass" :
               "is no checkpoint");
    return text.substr(format.size(),
                       text.size() - format.size() - Checksum().size());
  }
} // namespace Sandglass
