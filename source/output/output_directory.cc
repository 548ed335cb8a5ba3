#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/output/output_directory.h>

#include <filesystem>

namespace Sandglass
{
  using namespace dealii;

  std::string
  shared_error(const MPI_Comm communicator, const std::function<void()> &work)
  {
    std::string message;
    try
      {
        work();
      }
    catch (const std::exception &error)
      {
        message = error.what();
      }
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    if (n_ranks == 1)
      return message;
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int first_rank =
      Utilities::MPI::min(message.empty() ? n_ranks : rank, communicator);
    return first_rank == n_ranks ?
             std::string() :
             Utilities::MPI::broadcast(communicator, message, first_rank);
  }



  void
  do_and_share_errors(const MPI_Comm               communicator,
                      const std::function<void()> &work)
  {
    const std::string message = shared_error(communicator, work);
    if (!message.empty())
      throw RunError(message);
  }



  void
  prepare_output_directory(const OutputParameters &parameters,
                           const bool              is_restart,
                           const MPI_Comm          communicator,
                           Log                    &log,
                           const std::string      &folder)
  {
    const std::string &directory = parameters.directory;
    const std::string  message   = shared_error(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      std::filesystem::create_directories(directory + "/" + folder);
      log.open_file(directory + "/sandglass.log", is_restart);
      ParameterAcceptor::prm.print_parameters(directory + "/parameters.prm",
                                              ParameterHandler::PRM);
    });
    if (!message.empty())
      throw InputError("Output",
                       "Directory",
                       directory,
                       "allowed is a directory that can be made and written (" +
                         message + ")");
  }
} // namespace Sandglass
