#include <sandglass/base/exceptions.h>
#include <sandglass/output/replace_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace Sandglass
{
  namespace
  {
    [[noreturn]] void
    throw_last_error()
    {
      throw std::system_error(errno, std::generic_category());
    }



    void
    write_all(const int descriptor, const std::string &content)
    {
      for (std::size_t n_written = 0; n_written < content.size();)
        {
          const ssize_t n = write(descriptor,
                                  content.data() + n_written,
                                  content.size() - n_written);
          if (n < 0 && errno != EINTR)
            throw_last_error();
          n_written += n > 0 ? n : 0;
        }
    }



    void
    write_file(const std::string &filename,
               const std::string &content,
               const Survives     survives)
    {
      constexpr mode_t readable   = 0666; // less what the user's umask forbids
      const int        descriptor = open(filename.c_str(),
                                  O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC,
                                  readable);
      if (descriptor < 0)
        throw_last_error();
      try
        {
          write_all(descriptor, content);
          if (survives == Survives::machine && fsync(descriptor) != 0)
            throw_last_error();
        }
      catch (...)
        {
          close(descriptor);
          throw;
        }
      // Some file systems find out here that there is no room.
      if (close(descriptor) != 0)
        throw_last_error();
    }



    /// Whether there is hardly room for a file where this one lies.
    bool
    is_disk_full(const std::string &filename)
    {
      constexpr std::uintmax_t hardly_any = 64 * 1024;

      std::error_code error;
      const auto      space =
        std::filesystem::space(std::filesystem::path(filename).parent_path(),
                               error);
      return !error && space.available < hardly_any;
    }
  } // namespace



  void
  throw_unwritable(const std::string &filename)
  {
    const int reason = errno;
    if (reason == ENOSPC || reason == EDQUOT || is_disk_full(filename))
      throw RunError("The disk is full: '" + filename +
                     "' can't be written. Make room, and go on from the last "
                     "checkpoint with --restart, if there is one.");
    throw RunError("'" + filename + "' can't be written" +
                   (reason == 0 ? std::string() :
                                  ": " + std::string(std::strerror(reason))) +
                   ". Is its directory still there, and is it yours?");
  }



  std::string
  unfinished_name(const std::string &filename)
  {
    return filename + ".new";
  }



  void
  replace_file(const std::string &filename,
               const std::string &content,
               const Survives     survives)
  {
    const std::string unfinished = unfinished_name(filename);
    try
      {
        write_file(unfinished, content, survives);
        std::filesystem::rename(unfinished, filename);
      }
    catch (const std::system_error &error)
      {
        std::error_code ignored;
        std::filesystem::remove(unfinished, ignored);
        errno = error.code().value();
        throw_unwritable(filename);
      }
  }
} // namespace Sandglass
