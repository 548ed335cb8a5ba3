#ifndef sandglass_run_stop_parameters_h
#define sandglass_run_stop_parameters_h

#include <deal.II/base/parameter_acceptor.h>

namespace Sandglass
{
  /// Section `Stop`: what ends a run before its end time.
  class StopParameters : public dealii::ParameterAcceptor
  {
  public:
    StopParameters();

    bool   when_empty      = false;
    double discharged_mass = 0.; ///< of the whole silo, in kg; 0: none
    double steady_within   = 0.; ///< in %; 0: never
    double steady_time     = 1.; ///< in s

    bool
    is_on() const
    {
      return when_empty || discharged_mass > 0. || steady_within > 0.;
    }
  };
} // namespace Sandglass

#endif
