#ifndef sandglass_output_log_h
#define sandglass_output_log_h

#include <deal.II/base/conditional_ostream.h>

#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * What the program tells its user: on the screen, as far as that is wanted,
   * and in a file. Only rank 0 writes.
   */
  class Log
  {
  public:
    /// What of it the screen shows; the file has all.
    enum class Screen
    {
      everything,
      progress, ///< lines about the progress only
      nothing
    };

    Log(const MPI_Comm communicator, const Screen screen);
    ~Log();

    /// Stream for all text.
    dealii::ConditionalOStream &
    stream()
    {
      return output;
    }

    /// A line for each.
    void
    warn(const std::vector<std::string> &warnings);

    /// Keep a copy in a file from now on, and of what was written so far.
    void
    open_file(const std::string &filename, const bool appends);

    /**
     * A line about the progress: on a terminal it takes the place of the last
     * one, otherwise it is a line like others.
     */
    void
    show_progress(const std::string &line);

    /// A line for the file only: the screen gets it on its error stream.
    void
    record_error(const std::string &line);

  private:
    /// Writes to the screen and to the file, or to memory before it is open.
    class Splitter;

    std::unique_ptr<Splitter>  splitter;
    std::ostream               split_stream;
    dealii::ConditionalOStream output;
  };
} // namespace Sandglass

#endif
