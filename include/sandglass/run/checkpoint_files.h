#ifndef sandglass_run_checkpoint_files_h
#define sandglass_run_checkpoint_files_h

#include <string>

namespace Sandglass
{
  /**
   * The files of checkpoints in an output directory: the last one, and the one
   * before it. They hold any bytes, with a checksum.
   */
  class CheckpointFiles
  {
  public:
    explicit CheckpointFiles(const std::string &directory);

    /**
     * Write the next one; the last one becomes the one before it. At any moment
     * there is a last one that is whole, once there has been one, also after
     * the machine fails. On one rank. Throws RunError.
     *
     * @param content  what read_checkpoint_content() will return.
     */
    void
    write(const std::string &content) const;

    const std::string last, before;
  };

  /// What the file of a checkpoint holds. Throws InputError, which names the
  /// file, where it can't be read, is of another version of Sandglass, or is
  /// damaged: where any bit differs from what was written.
  std::string
  read_checkpoint_content(const std::string &filename);
} // namespace Sandglass

#endif
