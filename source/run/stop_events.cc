#include <deal.II/base/mpi.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/run/stop_events.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    double
    last_time(const GateParameters &gates)
    {
      double time = 0.;
      for (const auto &[name, numbers] : gates.openings)
        time = std::max(time, numbers[numbers.size() - 2]);
      return time;
    }
  } // namespace



  StopEvents::StopEvents(const StopParameters &parameters,
                         const GateParameters &gates,
                         const MPI_Comm        communicator)
    : parameters(parameters)
    , last_gate_time(last_time(gates))
    , communicator(communicator)
  {}



  template <int dim>
  void
  StopEvents::after_step(const Observers<dim> &observers)
  {
    if (!parameters.is_on() || observers.last_row_step() == last_step)
      return;
    last_step = observers.last_row_step();
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      event =
        find_event(observers.discharge(), observers.what_happened().clock.time);
    event = Utilities::MPI::broadcast(communicator, event);
  }



  std::string
  StopEvents::find_event(const FlowRate &discharge, const double time) const
  {
    std::ostringstream text;
    if (parameters.discharged_mass > 0. &&
        discharge.mass() >= parameters.discharged_mass)
      text << "a mass of " << parameters.discharged_mass
           << " kg has been discharged";
    else if (parameters.steady_within > 0. &&
             discharge.spread(time - parameters.steady_time) <=
               parameters.steady_within / 100.)
      text << "the flow has been steady within " << parameters.steady_within
           << " % for " << parameters.steady_time << " s";
    else if (parameters.when_empty && time >= last_gate_time &&
             !std::isnan(discharge.discharge_time()))
      text << "the silo has emptied";
    return text.str();
  }



#define INSTANTIATE(dim) \
  template void StopEvents::after_step(const Observers<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
