#ifndef sandglass_flow_particle_in_cell_step_control_h
#define sandglass_flow_particle_in_cell_step_control_h

#include <limits>

namespace Sandglass
{
  /// What the automatic time step remembers from one look at the critical step
  /// to the next.
  struct StepControl
  {
    /// Without the cut at the end, in s; 0: not known yet.
    double automatic_time_step = 0.;

    /// The stiffest node's eigenvalue when that step was found, in 1/s^2.
    double last_local_eigenvalue = 0.;

    /// The critical step found with it, in s; 0: none yet.
    double last_critical_time_step = 0.;

    /**
     * Critical step of the material as it is seeded, in s, and its stiffest
     * node's eigenvalue. The automatic step is not based on a longer one: where
     * little material is left, most of it separated, the critical step is long
     * or infinite, but falls within a few steps when that material comes
     * together again.
     */
    double seeded_critical_time_step = std::numeric_limits<double>::infinity();
    double seeded_local_eigenvalue   = 0.;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &automatic_time_step &last_local_eigenvalue
        &last_critical_time_step &seeded_critical_time_step
          &seeded_local_eigenvalue;
    }
  };
} // namespace Sandglass

#endif
