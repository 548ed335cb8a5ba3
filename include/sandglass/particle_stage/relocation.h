#ifndef sandglass_particle_stage_relocation_h
#define sandglass_particle_stage_relocation_h

#include <sandglass/particle_stage/clock.h>
#include <sandglass/particle_stage/particle_stage_parameters.h>
#include <sandglass/particle_stage/wall_impulse.h>
#include <sandglass/particles/cell_geometry.h>
#include <sandglass/particles/particle_cloud.h>
#include <sandglass/particles/strays.h>
#include <sandglass/walls/friction.h>
#include <sandglass/walls/wall_parameters.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// Masses that have left the grid, on this rank, in kg.
  struct RemovedMass
  {
    double discharged = 0.; ///< through the fall region's open boundary
    double lost       = 0.; ///< anywhere else
  };

  /**
   * The end of step 9 of Section 4.4: finds the new cell of each stray, hands
   * it over, and removes what has left through the fall region. Only particles
   * that changed cell cost anything.
   */
  template <CellType cell_type>
  class Relocation
  {
  public:
    using Geometry = CellGeometry<cell_type>;

    /// Face distance, in cells, that a particle may be beyond a wall or the
    /// axis by rounding; it is put back.
    static constexpr double rounding = 1e-9;

    /// Smallest face distance that a particle in a cell has: nodes opposite a
    /// particle on an edge get a little of its mass, and so a velocity.
    static constexpr double margin = 1e-12;

    Relocation(const Scene                   &scene,
               const Geometry                &geometry,
               const WallParameters          &walls,
               const ParticleStageParameters &parameters);

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
    relocate(Strays &strays, ParticleCloud &cloud, const Clock &clock);

    RemovedMass removed;

    /// What walls beside a free lip did to particles in the last relocate().
    std::vector<WallImpulse> wall_impulses;

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

    /// Put a particle beyond a wall back onto it, and stop its motion into it
    /// as far as friction and wall do.
    Location
    hold_at_wall(Parcel &stray, const Location &location);

    void
    report_fault(const Parcel &stray, const Location &location);

    void
    throw_if_faulty(const Clock &clock) const;

    const Geometry &geometry;
    const MPI_Comm  communicator;
    const double    friction_coefficient;
    const bool      stops_at_loss;

    /// Whether the cell has the outlet lip's node; empty unless the lip is
    /// free.
    std::vector<bool> is_at_free_lip;

    std::string fault;

    /// Kept between calls to avoid allocation.
    std::vector<ParticleSlot> arrivals;
  };
} // namespace Sandglass

#endif
