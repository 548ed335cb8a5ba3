#include <sandglass/base/exceptions.h>
#include <sandglass/output/csv_file.h>
#include <sandglass/run/checkpoint.h>
#include <sandglass/run/checkpoint_files.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <filesystem>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// Call `read(archive)`; throws InputError where it can't be read.
    template <typename Read>
    void
    read_archive(const std::string &content,
                 const std::string &filename,
                 const Read        &read)
    {
      try
        {
          std::istringstream              stream(content);
          boost::archive::binary_iarchive archive(stream);
          read(archive);
        }
      catch (const InputError &)
        {
          throw;
        }
      catch (const std::exception &error)
        {
          throw InputError("--restart: '" + filename + "' can't be read (" +
                             error.what() + "); run again without --restart",
                           "Output",
                           "Directory");
        }
    }



    bool
    is_whole(const std::string &filename)
    {
      try
        {
          read_checkpoint_content(filename);
          return true;
        }
      catch (const InputError &)
        {
          return false;
        }
    }



    /// What the file holds. Throws InputError, with the file before it where
    /// that would do.
    std::string
    read_or_offer(const CheckpointPlace &place)
    {
      const CheckpointFiles files(place.directory);
      std::string           message;
      try
        {
          if (std::filesystem::exists(place.file))
            return read_checkpoint_content(place.file);
          message = "--restart: there is no '" + place.file +
                    "'; allowed is the output directory of a run with a "
                    "Checkpoint interval greater than 0, or that a signal has "
                    "stopped";
        }
      catch (const InputError &error)
        {
          message = error.what();
        }
      if (place.file != files.before && is_whole(files.before))
        message += ". The checkpoint before it is whole: go on from that with "
                   "--restart-from " +
                   files.before;
      throw InputError(message, "Output", "Directory");
    }



    void
    refuse_early_end(const double       time,
                     const double       end_time,
                     const std::string &filename)
    {
      // Of the sum of many steps.
      constexpr double rounding = 1e-12;
      if (end_time <= time * (1. + rounding))
        throw InputError("Particle stage",
                         "End time",
                         to_text(end_time),
                         "--restart: allowed is later than the time of '" +
                           filename + "', " + to_text(time) + " s");
    }
  } // namespace



  void
  write_checkpoint(const std::string &directory,
                   const Fingerprint &fingerprint,
                   const Checkpoint  &checkpoint)
  {
    std::ostringstream content;
    {
      boost::archive::binary_oarchive archive(content);
      archive << fingerprint << checkpoint;
    }
    CheckpointFiles(directory).write(content.str());
  }



  CheckpointPlace::CheckpointPlace(const std::string &path)
    : directory(path)
    , file(CheckpointFiles(path).last)
  {
    const std::filesystem::path whole(path);
    if (!std::filesystem::is_regular_file(whole))
      return;
    directory = whole.has_parent_path() ? whole.parent_path().string() : ".";
    file      = path;
  }



  Checkpoint
  read_checkpoint(const CheckpointPlace &place,
                  const Fingerprint     &fingerprint,
                  const double           end_time)
  {
    const std::string content = read_or_offer(place);
    Checkpoint        checkpoint;
    read_archive(content, place.file, [&](auto &archive) {
      Fingerprint written;
      archive >> written;
      refuse_changes(written, fingerprint, place.file);
      archive >> checkpoint;
    });
    refuse_early_end(checkpoint.time, end_time, place.file);
    return checkpoint;
  }
} // namespace Sandglass
