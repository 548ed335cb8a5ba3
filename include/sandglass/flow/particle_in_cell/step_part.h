#ifndef sandglass_flow_particle_in_cell_step_part_h
#define sandglass_flow_particle_in_cell_step_part_h

#include <array>
#include <cstddef>

namespace Sandglass
{
  /// What a step of the particle stage consists of, in this order.
  enum class StepPart
  {
    mass_matrix,       ///< step 2, where it isn't lumped or particles are new
    time_step,         ///< the critical one from time to time, its signs always
    nodal_equations,   ///< steps 2, 4 and 5, contact included
    velocity_map,      ///< step 7
    volumetric_strain, ///< averaged over cells
    particles,         ///< steps 6, 8 and 9: stress, density, position, sums
    relocation,        ///< of particles that have left their cells
    splitting,         ///< of those that fill too many cells
    sums_at_nodes,     ///< steps 2 to 4, from the cells
    order,             ///< of the particles in memory; their largest speed
    done               ///< the step's end
  };

  inline constexpr std::array<const char *, 10> step_part_names{
    {"mass_matrix",
     "time_step",
     "nodal_equations",
     "velocity_map",
     "volumetric_strain",
     "particles",
     "relocation",
     "splitting",
     "sums_at_nodes",
     "order"}};

  static_assert(step_part_names.size() ==
                  static_cast<std::size_t>(StepPart::done),
                "each part has a name");

  /// Who wants to know where a step's time goes, as benchmarks do.
  class StepWatcher
  {
  public:
    virtual ~StepWatcher() = default;

    /// This part begins, and the one before it ends.
    virtual void
    begin(const StepPart part) = 0;
  };
} // namespace Sandglass

#endif
