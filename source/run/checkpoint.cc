#include <sandglass/base/exceptions.h>
#include <sandglass/output/csv_file.h>
#include <sandglass/output/replace_file.h>
#include <sandglass/run/checkpoint.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <fstream>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// To be raised whenever what any class writes into archives changes.
    const std::string format = "Sandglass checkpoint 8";

    /// Call `read(archive)`; throws InputError where it can't be read.
    template <typename Read>
    void
    read_archive(std::istream      &stream,
                 const std::string &filename,
                 const Read        &read)
    {
      try
        {
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



  std::string
  checkpoint_file(const std::string &directory)
  {
    return directory + "/checkpoint.bin";
  }



  void
  write_checkpoint(const std::string &directory,
                   const Fingerprint &fingerprint,
                   const Checkpoint  &checkpoint)
  {
    std::ostringstream content;
    {
      boost::archive::binary_oarchive archive(content);
      archive << format << fingerprint << checkpoint;
    }
    replace_file(checkpoint_file(directory), content.str());
  }



  Checkpoint
  read_checkpoint(const std::string &directory,
                  const Fingerprint &fingerprint,
                  const double       end_time)
  {
    const std::string filename = checkpoint_file(directory);
    std::ifstream     file(filename, std::ios::binary);
    if (!file)
      throw InputError("--restart: there is no '" + filename +
                         "'; allowed is the output directory of a run with a "
                         "Checkpoint interval greater than 0",
                       "Output",
                       "Directory");
    Checkpoint checkpoint;
    read_archive(file, filename, [&](auto &archive) {
      std::string written_format;
      archive >> written_format;
      if (written_format != format)
        throw InputError("--restart: '" + filename +
                         "' is of another version of Sandglass");
      Fingerprint written;
      archive >> written;
      refuse_changes(written, fingerprint, filename);
      archive >> checkpoint;
    });
    refuse_early_end(checkpoint.time, end_time, filename);
    return checkpoint;
  }
} // namespace Sandglass
