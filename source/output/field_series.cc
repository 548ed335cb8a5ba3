#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <sandglass/output/field_series.h>
#include <sandglass/output/own_files.h>
#include <sandglass/output/replace_file.h>

#include <filesystem>
#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    const std::string subdirectory = field_directory + '/';
  } // namespace



  FieldSeries::FieldSeries(const std::string &directory,
                           const std::string &name,
                           const MPI_Comm     communicator)
    : directory(directory + '/')
    , name(name)
    , rank(Utilities::MPI::this_mpi_process(communicator))
    , n_ranks(Utilities::MPI::n_mpi_processes(communicator))
  {}



  void
  FieldSeries::open() const
  {
    if (rank != 0 || times_and_names.empty())
      return;
    write_pvd();
    remove_later_files();
  }



  void
  FieldSeries::remove_later_files() const
  {
    const std::string beginning = subdirectory + name + '_';
    for (const std::string &file : own_files(directory, OwnFile::result))
      if (file.rfind(beginning, 0) == 0 &&
          std::stoul(file.substr(beginning.size())) >= times_and_names.size())
        std::filesystem::remove(directory + file);
  }



  void
  FieldSeries::write(const double time, const VtuPiece &piece)
  {
    const std::string stem =
      name + '_' + Utilities::int_to_string(times_and_names.size(), 5);
    const auto piece_name = [this, &stem](const unsigned int rank) {
      return n_ranks == 1 ?
               stem + ".vtu" :
               stem + '.' + Utilities::int_to_string(rank, 4) + ".vtu";
    };

    std::filesystem::create_directories(directory + subdirectory);
    write_vtu(directory + subdirectory + piece_name(rank), piece);
    times_and_names.emplace_back(time,
                                 subdirectory + stem +
                                   (n_ranks == 1 ? ".vtu" : ".pvtu"));
    if (rank != 0)
      return;
    if (n_ranks > 1)
      {
        std::vector<std::string> piece_names;
        for (unsigned int r = 0; r < n_ranks; ++r)
          piece_names.push_back(piece_name(r));
        write_pvtu(directory + times_and_names.back().second,
                   piece,
                   piece_names);
      }
    write_pvd();
  }



  void
  FieldSeries::write_pvd() const
  {
    std::ostringstream content;
    content.precision(15);
    DataOutBase::write_pvd_record(content, times_and_names);
    replace_file(directory + name + ".pvd", content.str());
  }
} // namespace Sandglass
