#ifndef sandglass_run_stop_signals_h
#define sandglass_run_stop_signals_h

#include <mpi.h>
#include <signal.h>

#include <array>
#include <stdexcept>
#include <string>

namespace Sandglass
{
  /**
   * While it lives, SIGTERM and SIGINT ask the run to stop where it can go on
   * from later, instead of ending the process. A second one of the same kind
   * ends it. Ranks agree on when to stop, whichever has got the signal.
   */
  class StopSignals
  {
  public:
    explicit StopSignals(const MPI_Comm communicator);

    StopSignals(const StopSignals &) = delete;
    StopSignals &
    operator=(const StopSignals &) = delete;

    ~StopSignals();

    /**
     * The signal that all ranks stop for now; 0: none. To be asked after each
     * step, on all ranks. Costs nothing on one rank; on several, they agree
     * beside the steps, some steps later.
     */
    int
    after_step();

    /// Likewise at once, after what takes longer. Collective.
    int
    now() const;

  private:
    /// On several ranks: what has been asked, and the answer.
    void
    ask();

    MPI_Comm                        communicator;
    unsigned int                    n_ranks;
    std::array<struct sigaction, 2> former_actions;
    unsigned long                   n_steps = 0;
    MPI_Request                     request = MPI_REQUEST_NULL;
    int                             sent = 0, received = 0;
  };

  /// The run has stopped for a signal, on all ranks. The message says where,
  /// and how it goes on.
  class RunStopped : public std::runtime_error
  {
  public:
    RunStopped(const std::string &message, const int signal)
      : std::runtime_error(message)
      , signal(signal)
    {}

    /// Of the process, as shells know it.
    int
    exit_code() const
    {
      constexpr int shells_offset = 128;
      return shells_offset + signal;
    }

    const int signal;
  };

  /// Its name, such as SIGTERM.
  std::string
  name_of_signal(const int signal);
} // namespace Sandglass

#endif
