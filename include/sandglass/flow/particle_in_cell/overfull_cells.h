#ifndef sandglass_flow_particle_in_cell_overfull_cells_h
#define sandglass_flow_particle_in_cell_overfull_cells_h

#include <sandglass/flow/particle_in_cell/feed_parameters.h>
#include <sandglass/flow/particle_in_cell/nodal_sums.h>
#include <sandglass/flow/particle_in_cell/particle_stage_parameters.h>
#include <sandglass/particles/cell_moments.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Sandglass
{
  /// Whether the parameters ask for OverfullCells. Without an open outlet
  /// material rests, so that cells don't gather particles.
  bool
  relieves_overfull_cells(const ParticleStageParameters &parameters,
                          const FeedParameters          &feed,
                          const bool is_in_unequal_hexahedra,
                          const bool has_open_outlet);

  /**
   * The rate in 1/s at which particles are compacted that fill a neighbourhood
   * of cells too much; 0 where they don't.
   *
   * @param filling  volume of the particles over that of the cells.
   * @param side     of a cell, in m.
   * @param gravity  in m/s^2.
   */
  double
  relief_rate(const double filling, const double side, const double gravity);

  /**
   * Relieves cells in which more particles have gathered than there is room
   * for.
   *
   * A particle's density follows from the strains that it has met, not from its
   * neighbours. Where these are averages (VolumetricAverage), particles can
   * gather in a cell or leave it without a change of pressure: the average
   * vanishes where the cells' own rates cancel. In flow they are soon gone. In
   * a slow corner beside the outlet they stay, and in a long run it comes to
   * hold several times its mass (doc/results/operation.md). Separated ones
   * gather as well: they expand in any disturbance, but from the material's
   * density on they resist compaction, so that on the whole they expand. In
   * hexahedra a crater's slope sends them down as loose as that, and cells of
   * the flow below come to hold two or three times what they should
   * (doc/three-dimensions.md).
   *
   * Here the filling of a node's cells is the volume of their particles over
   * their own, separated ones as dense as unstressed material. Where it is too
   * large, the averages at the node get a compaction with relief_rate()
   * besides: the particles' density comes nearer to what the cells really hold,
   * and pressure rises until as much flows out. So the compaction that a cell
   * takes is an average as the rates are, and there are velocities of the nodes
   * that undo it. Separated particles take the mean of their cell's nodes.
   */
  template <typename Setting>
  class OverfullCells
  {
  public:
    static constexpr int dim = Setting::dim;

    using Shape    = typename Setting::Shape;
    using Geometry = CellGeometry<Setting::cell_type>;
    using Blocks   = ParticleBlocks<typename Setting::Layout>;

    /// @param cells         of this rank.
    /// @param points        where a cell's particles start.
    /// @param full_density  of unstressed material, in kg/m^3.
    /// @param gravity       its size, in m/s^2.
    OverfullCells(const Utilities::MPI::Partitioner &nodes,
                  const Geometry                    &geometry,
                  const std::vector<unsigned int>   &cells,
                  const std::vector<Point<dim>>     &points,
                  const double                       full_density,
                  const double                       gravity)
      : geometry(geometry)
      , full_density(full_density)
      , gravity(gravity)
      , n_owned_nodes(nodes.locally_owned_size())
      , cells_at_nodes(nodes)
      , particles_at_nodes(nodes)
      , compaction_at_nodes(nodes)
    {
      cells_at_nodes.start_sum();
      for (const unsigned int cell : cells)
        {
          const Shape &shape = geometry.shape(cell);
          const double area =
            part_area(shape, point_of(point_within<Shape>()), 1);
          const double side = dim == 2 ? std::sqrt(area) : std::cbrt(area);
          const double volume =
            cell_moments<typename Setting::Kinematics>(shape, points).volume;
          for (const unsigned int node : geometry.nodes(cell))
            {
              double *values = cells_at_nodes.at(node);
              values[Value::volume] += volume;
              values[Value::volume_times_side] += volume * side;
            }
        }
      cells_at_nodes.finish_sum();
    }

    /// Sum up the particles' volumes, and find the compaction. Collective.
    ///
    /// @param sums  of the particles' present positions.
    void
    compute(const Blocks &blocks, const NodalSums<Setting> &sums)
    {
      particles_at_nodes.start_sum();
      for_each_filled_cell(blocks, [&](const unsigned int cell) {
        const auto &of_cell = sums[cell];
        // The second is larger where there are separated ones.
        const double volume =
          std::max(of_cell.values[CellSums<Setting, double>::dense_volume],
                   of_cell.total_mass() / full_density);
        for (const unsigned int node : geometry.nodes(cell))
          *particles_at_nodes.at(node) += volume;
      });
      particles_at_nodes.finish_sum();
      for (unsigned int node = 0; node < n_owned_nodes; ++node)
        *compaction_at_nodes.at(node) = compaction_of_filling(node);
      compaction_at_nodes.update_ghosts();
    }

    /// Of the cells around a node that this rank owns: 1 as at the start.
    double
    filling(const unsigned int node) const
    {
      return *particles_at_nodes.at(node) /
             cells_at_nodes.at(node)[Value::volume];
    }

    /// At any node of this rank's cells, in 1/s.
    double
    compaction_rate(const unsigned int node) const
    {
      return *compaction_at_nodes.at(node);
    }

  private:
    /// Sums over the cells around a node.
    enum Value : unsigned int
    {
      volume,            ///< in m^3
      volume_times_side, ///< of squares as large as the cells, in m^4
      n_values
    };

    double
    compaction_of_filling(const unsigned int node) const
    {
      const double *values = cells_at_nodes.at(node);
      return relief_rate(filling(node),
                         values[Value::volume_times_side] /
                           values[Value::volume],
                         gravity);
    }

    const Geometry      &geometry;
    const double         full_density; ///< in kg/m^3
    const double         gravity;      ///< in m/s^2
    const unsigned int   n_owned_nodes;
    NodalField<n_values> cells_at_nodes;
    NodalField<1>        particles_at_nodes;  ///< their volume, in m^3
    NodalField<1>        compaction_at_nodes; ///< in 1/s
  };
} // namespace Sandglass

#endif
