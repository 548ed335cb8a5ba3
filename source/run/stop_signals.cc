#include <deal.II/base/mpi.h>

#include <sandglass/run/stop_signals.h>

#include <chrono>
#include <exception>
#include <thread>

namespace Sandglass
{
  namespace
  {
    constexpr std::array<int, 2> stopping_signals = {{SIGTERM, SIGINT}};

    /// What has arrived on this rank.
    volatile sig_atomic_t arrived_signal = 0;

    void
    note(const int signal)
    {
      arrived_signal = signal;
    }
  } // namespace



  StopSignals::StopSignals(const MPI_Comm parent)
    : n_ranks(dealii::Utilities::MPI::n_mpi_processes(parent))
  {
    MPI_Comm_dup(parent, &communicator);
    struct sigaction action = {};
    action.sa_handler       = note;
    // Only the first one is noted; reads and writes go on behind it.
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    for (unsigned int i = 0; i < stopping_signals.size(); ++i)
      {
        const int signal = stopping_signals[i];
        sigaction(signal, nullptr, &former_actions[i]);
        // As shells let what runs in the background ignore SIGINT.
        if (former_actions[i].sa_handler != SIG_IGN)
          sigaction(signal, &action, nullptr);
      }
  }



  StopSignals::~StopSignals()
  {
    for (unsigned int i = 0; i < stopping_signals.size(); ++i)
      sigaction(stopping_signals[i], &former_actions[i], nullptr);

    // A rank that has failed alone must not wait for the others for ever.
    const auto give_up =
      std::chrono::steady_clock::now() + std::chrono::seconds(2);
    int is_answered = request == MPI_REQUEST_NULL;
    while (!is_answered && (std::uncaught_exceptions() == 0 ||
                            std::chrono::steady_clock::now() < give_up))
      {
        MPI_Test(&request, &is_answered, MPI_STATUS_IGNORE);
        std::this_thread::yield();
      }
    if (is_answered)
      MPI_Comm_free(&communicator);
  }



  void
  StopSignals::ask()
  {
    sent = arrived_signal;
    MPI_Iallreduce(
      &sent, &received, 1, MPI_INT, MPI_MAX, communicator, &request);
  }



  int
  StopSignals::after_step()
  {
    if (n_ranks == 1)
      return arrived_signal;
    // After so many steps, in which ranks wait for each other anyway, the
    // answer has come.
    constexpr unsigned long period = 16;
    if (n_steps++ % period != 0)
      return 0;
    if (request != MPI_REQUEST_NULL)
      {
        MPI_Wait(&request, MPI_STATUS_IGNORE);
        if (received != 0)
          return received;
      }
    ask();
    return 0;
  }



  int
  StopSignals::now() const
  {
    return dealii::Utilities::MPI::max(static_cast<int>(arrived_signal),
                                       communicator);
  }



  std::string
  name_of_signal(const int signal)
  {
    return signal == SIGTERM ? "SIGTERM" :
           signal == SIGINT  ? "SIGINT" :
                               "signal " + std::to_string(signal);
  }
} // namespace Sandglass
