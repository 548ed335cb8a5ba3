#ifndef sandglass_run_stop_events_h
#define sandglass_run_stop_events_h

#include <sandglass/output/observers.h>
#include <sandglass/run/stop_parameters.h>
#include <sandglass/scene/gate_parameters.h>

#include <string>

namespace Sandglass
{
  /// Looks for the events that end a run before its end time.
  class StopEvents
  {
  public:
    StopEvents(const StopParameters &parameters,
               const GateParameters &gates,
               const MPI_Comm        communicator);

    /// Look whether an event has come, if the observers have written a row
    /// since the last call. Collective then.
    template <int dim>
    void
    after_step(const Observers<dim> &observers);

    /// Go on behind the last row of observers that do so themselves.
    template <int dim>
    void
    go_on_from(const Observers<dim> &observers)
    {
      last_step = observers.last_row_step();
    }

    /// The event, in words; empty while there is none.
    const std::string &
    what_has_come() const
    {
      return event;
    }

  private:
    /// @param time  of the last row of the discharge, in s.
    std::string
    find_event(const FlowRate &discharge, const double time) const;

    const StopParameters &parameters;
    const double          last_gate_time; ///< when no gate moves any more, in s
    const MPI_Comm        communicator;
    unsigned long         last_step = 0;
    std::string           event;
  };
} // namespace Sandglass

#endif
