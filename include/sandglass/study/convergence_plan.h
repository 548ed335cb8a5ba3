#ifndef sandglass_study_convergence_plan_h
#define sandglass_study_convergence_plan_h

#include <sandglass/run/parameter_file.h>
#include <sandglass/run/parameters.h>

#include <vector>

namespace Sandglass
{
  /// What a rate is extrapolated from, at least.
  constexpr unsigned int fewest_convergence_runs = 3;

  /// What a convergence study runs.
  struct ConvergencePlan
  {
    /// Times in s between which rates are means; the end is that of the runs.
    double window_start = 0., window_end = 0.;
    /// Values of Scene/Refinement, the coarsest first.
    std::vector<double> refinements;
  };

  /**
   * The plan for a silo; sets the end of the runs and a history that resolves
   * the window. Throws InputError where the silo has no flow rate, where the
   * run is too short for one, or where there are too few meshes.
   */
  ConvergencePlan
  plan_convergence(Parameters &parameters, const ParameterFile &file);
} // namespace Sandglass

#endif
