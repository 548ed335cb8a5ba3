#ifndef sandglass_output_output_directory_h
#define sandglass_output_output_directory_h

#include <sandglass/output/log.h>

#include <functional>
#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * An output directory while a run has it. Nobody else writes there, and it
   * holds nothing of an older run.
   *
   * The lock is the operating system's, on the directory itself, so that it
   * leaves no file and goes with the process, however that ends. Rank 0 has it.
   */
  class OutputDirectory
  {
  public:
    /**
     * Lock the directory, if there is one already; nothing is written.
     * Collective. Throws InputError where another run has it.
     */
    OutputDirectory(const std::string &path, const MPI_Comm communicator);

    OutputDirectory(const OutputDirectory &) = delete;
    OutputDirectory &
    operator=(const OutputDirectory &) = delete;

    ~OutputDirectory();

    /**
     * Make the directory, remove all files that older runs have left there (see
     * own_file()), and open sandglass.log. Collective. Throws InputError if the
     * directory can't be made or written, and nothing has changed then;
     * RunError where what is in it can't.
     */
    void
    start(Log &log);

    /**
     * Likewise, but go on with what a run has left in a directory: the same
     * one, or another, whose results are copied then.
     */
    void
    go_on(const std::string &source, Log &log);

    /// Remove what runs have left in subdirectories whose name begins so.
    /// Collective. Throws RunError.
    void
    clear_subdirectories(const std::string &beginning) const;

    /// Write parameters.prm, which holds all parameters as used. Collective.
    /// Throws RunError.
    void
    write_parameters() const;

    const std::string path;

  private:
    /// Make the directory, and lock it. Collective. Throws InputError.
    void
    make(Log &log);
    /// On rank 0, where the directory is there. Throws std::runtime_error.
    void
    lock();
    void
    unlock();
    /// Whether what is locked is what is at the path.
    bool
    has_lock() const;

    const MPI_Comm communicator;
    const bool     is_writer;
    /// Of the directory, as the system numbers what is open; -1: it is not.
    int  descriptor    = -1;
    bool can_be_locked = true; ///< some file systems can't
  };

  /**
   * Do work in which ranks don't wait for each other, and tell all of them if
   * it went wrong on one. Collective.
   *
   * @return the message of the exception on the first rank that had one, or an
   *         empty text.
   */
  std::string
  shared_error(const MPI_Comm communicator, const std::function<void()> &work);

  /// Like shared_error(), but throws a RunError on each rank.
  void
  do_and_share_errors(const MPI_Comm               communicator,
                      const std::function<void()> &work);

  /// What to tell the user of an exception: its message, or what to try where
  /// memory has run out.
  std::string
  message_of(const std::exception &error);
} // namespace Sandglass

#endif
