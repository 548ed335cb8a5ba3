#include <deal.II/base/mpi.h>

#include <sandglass/run/flow_state.h>

#include <sstream>

namespace Sandglass
{
  std::string
  saved_state(const Flow &flow)
  {
    std::ostringstream stream;
    {
      boost::archive::binary_oarchive archive(stream);
      flow.save(archive);
    }
    return stream.str();
  }



  void
  load_state(const std::string &state, Flow &flow)
  {
    std::istringstream              stream(state);
    boost::archive::binary_iarchive archive(stream);
    flow.load(archive);
  }



  void
  hand_over(const Flow &from, Flow &to, const MPI_Comm communicator)
  {
    load_state(Utilities::MPI::broadcast(communicator, saved_state(from)), to);
  }
} // namespace Sandglass
