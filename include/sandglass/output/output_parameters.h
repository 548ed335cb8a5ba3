#ifndef sandglass_output_output_parameters_h
#define sandglass_output_output_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <sandglass/base/parameter_entries.h>

#include <string>

namespace Sandglass
{
  /// Section `Output`: what a run writes, where, and how often.
  class OutputParameters : public dealii::ParameterAcceptor
  {
  public:
    OutputParameters();

    /// Throws InputError where the parameters make no sense.
    void
    check() const;

    std::string directory = "output/plane-flat-bottom";

    double interval         = 0.1;  ///< between fields and wall tractions, in s
    double history_interval = 0.01; ///< between rows of the histories, in s
    double flow_rate_window = 0.1;  ///< in s

    bool writes_particles = true;
    bool writes_grid      = true;
    bool writes_walls     = true;

    /// How far stagnant material may have moved, in outlet widths; 0: the
    /// stagnant mass isn't computed.
    double stagnant_displacement = 0.1;

    /// Janssen's K; 0 takes the one of EN 1991-4.
    double lateral_pressure_ratio = 0.;

    /// C_op of EN 1991-4.
    double patch_load_factor = 1.;

    bool writes_residence = true;
    /// Points by name; none: no gauges.
    NamedNumbers gauges;

    double progress_interval   = 5.; ///< wall time in s; 0: no progress lines
    double checkpoint_interval = 0.; ///< simulated time in s; 0: none
  };
} // namespace Sandglass

#endif
