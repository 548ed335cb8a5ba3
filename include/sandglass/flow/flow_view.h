#ifndef sandglass_flow_flow_view_h
#define sandglass_flow_flow_view_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <sandglass/flow/clock.h>
#include <sandglass/material/state_variable.h>
#include <sandglass/walls/wall.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /**
   * Sums over all material of all ranks at one time, as far as the grid goes:
   * where the scene is half of a symmetric section, those of the half. In plane
   * strain, all are per metre of depth.
   */
  struct FlowTotals
  {
    unsigned long n_particles    = 0;
    unsigned long particle_steps = 0; ///< since this process started

    double mass_in_silo = 0.; ///< above the outlet level y = 0, in kg
    double mass_falling = 0.; ///< below it, in kg
    double mass_removed = 0.; ///< left the grid by falling, in kg
    double mass_lost    = 0.; ///< left the grid otherwise, in kg
    double mass_fed     = 0.; ///< entered since the start, in kg
    /// What has passed each of several outlets, in kg; see Scene::outlets.
    std::vector<double> mass_by_outlet;

    double kinetic_energy    = 0.; ///< in J
    double elastic_energy    = 0.; ///< of the material, in J
    double dissipated_energy = 0.; ///< by plastic flow and wall friction, in J
    /// Whether the law can't tell elastic energy from what is dissipated.
    bool   dissipation_can_fall = false;
    double wall_work = 0.; ///< done by moving walls on the material, in J

    Tensor<1, 3> momentum;           ///< in kg m/s
    double       largest_speed = 0.; ///< in m/s
  };

  /// What one wall has done at one node since the start, of one direction in
  /// which it holds the node.
  struct WallRecord
  {
    WallId       wall;
    unsigned int vertex;   ///< of the scene's mesh
    Point<3>     position; ///< in m
    Tensor<1, 3> normal;   ///< outward from the material
    double       area;     ///< in m^2 (plane strain: per metre of depth)
    Tensor<1, 3> impulse;  ///< on the material, in N s (per metre of depth)

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &wall &vertex &position &normal &area &impulse;
    }
  };

  /// The records of this rank's nodes.
  struct WallRecords
  {
    double time = 0.; ///< over which impulses were summed, in s
    std::vector<WallRecord> records;
  };

  /// Area of wall in m^2 (plane strain: per metre of depth) of this rank's
  /// nodes.
  struct WallArea
  {
    double touching; ///< where a wall held the material in the last step
    double sliding;  ///< the part of it where the material slid
  };

  /// One particle, as far as results show it.
  struct ParticleRecord
  {
    std::uint64_t         id;
    Point<3>              location;         ///< in m
    Point<3>              initial_location; ///< before the state at rest, in m
    Tensor<1, 3>          velocity;         ///< in m/s
    std::array<double, 6> stress;           ///< see SymmetricComponents, in Pa
    double                mass;             ///< in kg
    double                density;          ///< in kg/m^3
    const double         *law_state;        ///< see FlowView::state_variables()
  };

  /// One node of the grid, as far as results show it.
  struct NodeRecord
  {
    Point<3>     location; ///< in m
    double       mass;     ///< in kg
    Tensor<1, 3> velocity; ///< in m/s
  };

  /// One cell of the grid, as far as results show it.
  struct CellRecord
  {
    std::int64_t n_particles;
    std::int64_t subdomain; ///< rank that owns the cell
  };

  /// This rank's part of the grid.
  struct GridRecords
  {
    unsigned int              nodes_per_cell = 0;
    std::vector<std::int32_t> nodes_of_cells; ///< in VTK's order
    std::vector<NodeRecord>   nodes;
    std::vector<CellRecord>   cells;
  };

  /**
   * What output sees of a flow: it reads, and changes nothing. Vectors have
   * three components in all dimensions; those beyond the grid's are zero.
   */
  class FlowView
  {
  public:
    virtual ~FlowView() = default;

    virtual const Clock &
    clock() const = 0;

    /// Collective.
    virtual FlowTotals
    totals() const = 0;

    /**
     * The largest stable time step in s. Collective.
     *
     * @param is_exact  for these very positions, which costs about two steps,
     * or the one found last where the step follows it.
     */
    virtual double
    critical_time_step(const bool is_exact) const = 0;

    virtual WallArea
    wall_area() const = 0;

    /// Collective, since a wall's node may belong to another rank than the
    /// particle that it holds.
    virtual WallRecords
    wall_records() const = 0;

    /// The law's state variables.
    virtual std::vector<StateVariable>
    state_variables() const = 0;

    /// How many this rank has.
    virtual unsigned int
    n_particles() const = 0;

    virtual void
    for_each_particle(
      const std::function<void(const ParticleRecord &)> &function) const = 0;

    /// Collective.
    virtual GridRecords
    grid() const = 0;
  };
} // namespace Sandglass

#endif
