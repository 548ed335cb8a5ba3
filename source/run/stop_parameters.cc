#include <sandglass/base/parameter_entries.h>
#include <sandglass/run/stop_parameters.h>

namespace Sandglass
{
  StopParameters::StopParameters()
    : ParameterAcceptor("Stop")
  {
    using Bounds = BoundedNumber;

    add_flag(*this,
             "When empty",
             when_empty,
             "End the run when nothing flows out any more: when 99.9 % of what "
             "has been discharged had been so at least an Output/Flow rate "
             "window ago, and no gate will move. Whether this or what follows "
             "has come is looked at with each row of history.csv; "
             "summary.json says what has ended the run.");
    add_number(*this,
               "Discharged mass",
               discharged_mass,
               Bounds::at_least(0.),
               "kg",
               "End the run when so much has been discharged from the whole "
               "silo (plane strain: per metre of depth); 0: don't.");
    add_number(*this,
               "Steady within",
               steady_within,
               Bounds::at_least_below(0., 100.),
               "%",
               "End the run when the flow rate has been steady: when its "
               "largest and smallest value in the last Steady time are no more "
               "than this away from the middle between them; 0: don't.");
    add_number(*this,
               "Steady time",
               steady_time,
               Bounds::greater_than(0.),
               "s",
               "How long the flow rate has to be steady.");
  }
} // namespace Sandglass
