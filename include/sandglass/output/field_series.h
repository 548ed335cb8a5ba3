#ifndef sandglass_output_field_series_h
#define sandglass_output_field_series_h

#include <sandglass/output/vtu_file.h>

#include <mpi.h>

#include <string>
#include <utility>
#include <vector>

namespace Sandglass
{
  /**
   * A .pvd file that lists what was written at which time, and the files that
   * it lists, in the subdirectory `vtu`: one .vtu for each time, or one for
   * each rank and a .pvtu that joins them.
   */
  class FieldSeries
  {
  public:
    /**
     * @param directory  for the .pvd.
     * @param name       of the .pvd, and the beginning of the other names.
     * @param communicator  of the ranks that write.
     */
    FieldSeries(const std::string &directory,
                const std::string &name,
                const MPI_Comm     communicator);

    /// After deserialization: list what the archive knew of, and remove what
    /// was written later. The first rank does it.
    void
    open() const;

    /// Write this rank's piece; all ranks must, without waiting for each other.
    void
    write(const double time, const VtuPiece &piece);

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &times_and_names;
    }

  private:
    /// Rewrite the .pvd in one go, so that it is complete at any moment.
    void
    write_pvd() const;

    void
    remove_later_files() const;

    const std::string  directory;
    const std::string  name;
    const unsigned int rank;
    const unsigned int n_ranks;

    std::vector<std::pair<double, std::string>> times_and_names;
  };
} // namespace Sandglass

#endif
