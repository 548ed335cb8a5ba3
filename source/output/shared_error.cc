#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/output/output_directory.h>

#include <new>

namespace Sandglass
{
  using namespace dealii;

  std::string
  message_of(const std::exception &error)
  {
    const bool is_out_of_memory =
      dynamic_cast<const std::bad_alloc *>(&error) != nullptr ||
      dynamic_cast<const ExcOutOfMemory *>(&error) != nullptr;
    return is_out_of_memory ?
             "There is not enough memory. Try larger cells (a larger 'Element "
             "size' or a smaller 'Refinement' in section 'Scene'), or ranks on "
             "more machines." :
             error.what();
  }



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
        message = message_of(error);
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
} // namespace Sandglass
