#ifndef sandglass_output_flow_pattern_h
#define sandglass_output_flow_pattern_h

#include <sandglass/flow/flow_view.h>

#include <mpi.h>

#include <functional>
#include <limits>
#include <optional>

namespace Sandglass
{
  /**
   * What tells mass flow from funnel flow: where the material slips along the
   * walls, and how much of it stays where it is.
   */
  struct FlowPattern
  {
    FlowPattern() = default;

    /**
     * Collective. One pass over this rank's particles, where one is asked for.
     *
     * @param stagnant_displacement  in m; 0: no stagnant mass.
     * @param symmetry_factor        see Scene.
     * @param also                   is called with each particle; may be empty.
     */
    FlowPattern(const FlowView &view,
                const double    stagnant_displacement,
                const double    symmetry_factor,
                const MPI_Comm  communicator,
                const std::function<void(const ParticleRecord &)> &also = {});

    /// Share of the wall's area in contact where the material slides, in the
    /// last step; NaN where nothing is in contact.
    double slipping_wall_share = std::numeric_limits<double>::quiet_NaN();

    /// Mass in the whole silo that is no farther than the given displacement
    /// from where it was before the static stage, in kg.
    std::optional<double> stagnant_mass;
  };
} // namespace Sandglass

#endif
