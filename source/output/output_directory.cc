#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_acceptor.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/output/output_directory.h>
#include <sandglass/output/own_files.h>
#include <sandglass/output/replace_file.h>
#include <sandglass/output/summary_file.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace Sandglass
{
  using namespace dealii;
  namespace fs = std::filesystem;

  namespace
  {
    [[noreturn]] void
    refuse(const std::string &directory, const std::string &reason)
    {
      throw InputError("Output",
                       "Directory",
                       directory,
                       "allowed is a directory that can be made and written (" +
                         reason + ")");
    }



    void
    remove_files(const std::string &directory, const OwnFile kind)
    {
      for (const std::string &name : own_files(directory, kind))
        fs::remove(directory + '/' + name);
    }



    /// All files of older runs; first of all the one that says what the others
    /// are.
    void
    clear(const std::string &directory)
    {
      fs::remove(summary_file(directory));
      remove_files(directory, OwnFile::leftover);
      remove_files(directory, OwnFile::result);
      const std::string fields = directory + '/' + field_directory;
      if (fs::is_directory(fs::symlink_status(fields)) && fs::is_empty(fields))
        fs::remove(fields);
    }



    void
    copy_results(const std::string &from, const std::string &to)
    {
      fs::create_directories(to + '/' + field_directory);
      for (const std::string &name : own_files(from, OwnFile::result))
        fs::copy_file(from + '/' + name, to + '/' + name);
    }
  } // namespace



  OutputDirectory::OutputDirectory(const std::string &path,
                                   const MPI_Comm     communicator)
    : path(path)
    , communicator(communicator)
    , is_writer(Utilities::MPI::this_mpi_process(communicator) == 0)
  {
    const std::string message = shared_error(communicator, [this]() {
      if (is_writer && fs::is_directory(this->path))
        lock();
    });
    if (!message.empty())
      refuse(path, message);
  }



  OutputDirectory::~OutputDirectory()
  {
    unlock();
  }



  void
  OutputDirectory::lock()
  {
    descriptor = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
      throw std::system_error(errno, std::generic_category());
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0)
      return;
    if (errno != EWOULDBLOCK)
      {
        can_be_locked = false;
        return;
      }
    unlock();
    throw std::runtime_error("another run is writing there now; each needs a "
                             "directory of its own");
  }



  void
  OutputDirectory::unlock()
  {
    if (descriptor >= 0)
      close(descriptor);
    descriptor = -1;
  }



  bool
  OutputDirectory::has_lock() const
  {
    struct stat locked, found;
    return descriptor >= 0 && fstat(descriptor, &locked) == 0 &&
           stat(path.c_str(), &found) == 0 && locked.st_dev == found.st_dev &&
           locked.st_ino == found.st_ino;
  }



  void
  OutputDirectory::make(Log &log)
  {
    const std::string message = shared_error(communicator, [this]() {
      if (!is_writer)
        return;
      fs::create_directories(path);
      if (access(path.c_str(), W_OK | X_OK) != 0)
        throw std::system_error(errno, std::generic_category());
      if (!has_lock())
        {
          unlock();
          lock();
        }
    });
    if (!message.empty())
      refuse(path, message);
    if (!can_be_locked)
      log.warn({"the file system of '" + path +
                "' knows no locks: take care that no other run writes there."});
  }



  void
  OutputDirectory::start(Log &log)
  {
    make(log);
    do_and_share_errors(communicator, [&]() {
      if (!is_writer)
        return;
      clear(path);
      log.open_file(path + "/sandglass.log", false);
    });
    log.stream() << "Results go to " << path << std::endl;
  }



  void
  OutputDirectory::go_on(const std::string &source, Log &log)
  {
    make(log);
    do_and_share_errors(communicator, [&]() {
      if (!is_writer)
        return;
      const bool is_same = fs::equivalent(source, path);
      if (!is_same)
        {
          clear(path);
          copy_results(source, path);
        }
      // It shows what was there before.
      fs::remove(path + "/report.html");
      log.open_file(path + "/sandglass.log", is_same);
    });
    log.stream() << "Results go to " << path << std::endl;
  }



  void
  OutputDirectory::clear_subdirectories(const std::string &beginning) const
  {
    do_and_share_errors(communicator, [&]() {
      if (!is_writer)
        return;
      for (const auto &entry : fs::directory_iterator(path))
        if (entry.is_directory() &&
            entry.path().filename().string().rfind(beginning, 0) == 0)
          {
            clear(entry.path());
            if (fs::is_empty(entry.path()))
              fs::remove(entry.path());
          }
    });
  }



  void
  OutputDirectory::write_parameters() const
  {
    do_and_share_errors(communicator, [this]() {
      if (!is_writer)
        return;
      std::ostringstream text;
      ParameterAcceptor::prm.print_parameters(text, ParameterHandler::PRM);
      replace_file(path + "/parameters.prm", text.str());
    });
  }
} // namespace Sandglass
