#ifndef sandglass_flow_particle_in_cell_relocation_h
#define sandglass_flow_particle_in_cell_relocation_h

#include <sandglass/flow/clock.h>
#include <sandglass/flow/particle_in_cell/particle_stage_parameters.h>
#include <sandglass/flow/particle_in_cell/removed_mass.h>
#include <sandglass/flow/particle_in_cell/wall_impulse.h>
#include <sandglass/particles/cell_geometry.h>
#include <sandglass/particles/particle_cloud.h>
#include <sandglass/particles/strays.h>
#include <sandglass/walls/wall.h>
#include <sandglass/walls/wall_parameters.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * The end of step 9 of Section 4.4: finds the new cell of each stray, hands
   * it over, and removes what has left through the fall region. Only particles
   * that changed cell cost anything.
   */
  template <typename Setting>
  class Relocation
  {
  public:
    static constexpr int dim = Setting::dim;

    using Layout   = typename Setting::Layout;
    using Geometry = CellGeometry<Setting::cell_type>;
    using Parcel   = Sandglass::Parcel<Layout>;
    using Cloud    = ParticleCloud<Layout>;

    /// Face distance, in cells, that a particle may be beyond a wall or the
    /// axis by rounding; it is put back.
    static constexpr double rounding = 1e-9;

    /// Smallest face distance that a particle in a cell has: nodes opposite a
    /// particle on an edge get a little of its mass, and so a velocity.
    static constexpr double margin = 1e-12;

    Relocation(const Scene<dim>              &scene,
               const Geometry                &geometry,
               const WallParameters          &wall_parameters,
               const ParticleStageParameters &parameters,
               RemovedMass                   &removed);

    /**
     * Collective. Throws RunError on each rank if a particle is lost on any and
     * the parameters say stop, or if a position is not a number.
     *
     * @param strays  particles without a cell; empty afterwards.
     * @param cloud   takes those that are in the grid.
     * @param clock   tells step and time in the message.
     * @return where they are now; valid until the next call.
     */
    const std::vector<ParticleSlot> &
    relocate(Strays<Layout> &strays, Cloud &cloud, const Clock &clock);

    /// What walls beside a free lip did to particles in the last relocate().
    std::vector<WallImpulse<dim>> wall_impulses;

  private:
    using Location = typename Geometry::Location;

    /// Give a stray its new cell; returns whether it has one.
    bool
    find_cell(Parcel &stray);

    void
    settle(Parcel &stray, const Location &location) const;

    /// Whether a free lip's wall holds the particle itself.
    bool
    is_held_by_lip(const Parcel &stray, const Location &location) const;

    /// Where a particle has left the grid.
    struct Exit
    {
      Tensor<1, dim> normal;       ///< of the face, outwards
      double         distance;     ///< to the face, in m
      double         small_length; ///< less than which is at the face, in m
    };

    Exit
    find_exit(const Parcel &stray, const Location &location) const;

    /// Put a particle back to where it has left the grid: a little inside, so
    /// that the walk ends in a cell.
    Location
    put_back(Parcel &stray, const Exit &exit, const Location &location) const;

    /// Put a particle beyond a wall back onto it, and stop its motion into it
    /// as far as friction and wall do.
    Location
    hold_at_wall(Parcel &stray, const Location &location);

    /// Put a particle above the grid's top back, and stop its motion out of it:
    /// the material's surface may move up a little, and a light particle jump,
    /// where there are no cells.
    Location
    hold_at_top(Parcel &stray, const Location &location) const;

    void
    report_fault(const Parcel &stray, const Location &location);

    void
    throw_if_faulty(const Clock &clock) const;

    const Geometry               &geometry;
    const std::vector<Wall<dim>> &walls;
    RemovedMass                  &removed;
    const MPI_Comm                communicator;
    const bool                    stops_at_loss;
    const bool                    holds_at_top;

    /// Whether the cell has the outlet lip's node; empty unless the lip is
    /// free.
    std::vector<bool> is_at_free_lip;

    std::string fault;

    /// Kept between calls to avoid allocation.
    std::vector<ParticleSlot> arrivals;
  };
} // namespace Sandglass

#include <sandglass/flow/particle_in_cell/relocation.templates.h>

#endif
