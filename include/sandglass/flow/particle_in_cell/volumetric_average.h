#ifndef sandglass_flow_particle_in_cell_volumetric_average_h
#define sandglass_flow_particle_in_cell_volumetric_average_h

#include <sandglass/flow/particle_in_cell/nodal_sums.h>
#include <sandglass/flow/particle_in_cell/overfull_cells.h>
#include <sandglass/flow/particle_in_cell/volumetric_sums.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace Sandglass
{
  /**
   * The volumetric deformation rate of each cell, averaged over its
   * neighbourhood, against the locking of linear cells under plastic flow that
   * keeps the volume: first the mean of the cells at each node, weighted by the
   * volume over which the stress of their dense particles is integrated, then
   * the mean of the cell's nodes.
   *
   * Cells that hold less than one particle of usual size, filled to less than
   * a quarter, count and take the average by a share alpha, and for the rest
   * keep their own rate: else what is light would go on being pushed by the
   * pressure of heavy neighbours, however far it gives way.
   *
   * With the elastic law p = -K theta this is the average nodal pressure
   * element of Bonet and Burton (1998). With the cells' volumes V, their
   * weights w = alpha V and M, the means of a cell's nodes over the nodes' sums
   * of w, the volumes times the average are V (1 - alpha) + w M w. That is
   * symmetric, so the stiffness matrix stays symmetric, and the eigenvalues of
   * the average lie between 0 and 1, so the critical time step does not become
   * shorter.
   *
   * Separated particles, less dense than `smallest_density`, carry no stress;
   * they don't count, and keep their cell's rate.
   */
  template <typename Setting>
  class VolumetricAverage
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    static constexpr int          dim     = Setting::dim;

    using Geometry   = CellGeometry<Setting::cell_type>;
    using Blocks     = ParticleBlocks<typename Setting::Layout>;
    using Sums       = SumsByCell<Setting, VolumetricSums>;
    using RateChange = typename CellIntegration<Setting>::RateChange;

    /// @param smallest_density  of particles that count, in kg/m^3.
    VolumetricAverage(const Utilities::MPI::Partitioner &nodes,
                      const Geometry                    &geometry,
                      const double                       smallest_density,
                      const bool                         is_on)
      : is_on(is_on)
      , smallest_density(smallest_density)
      , geometry(geometry)
      , n_owned_nodes(nodes.locally_owned_size())
    {
      if (!is_on)
        return;
      nodal = std::make_unique<NodalField<n_values>>(nodes);
      own.resize(geometry.n_cells());
      if constexpr (!Setting::has_uniform_strain)
        {
          cells = std::make_unique<Sums>(geometry, smallest_density);
          rate_changes.resize(geometry.n_cells());
        }
    }

    /**
     * Find the averages for a velocity field with its ghosts. Collective; does
     * nothing if it is off.
     *
     * @param sums  of the particles' present positions, as `cells` are.
     */
    void
    compute(const Blocks             &blocks,
            const NodalSums<Setting> &sums,
            const NodalField<dim>    &velocity)
    {
      if (!is_on)
        return;
      nodal->start_sum();
      for_each_filled_cell_in_a_step(blocks, [&](const unsigned int cell) {
        add_to_nodes(cell, sums, gather(velocity, geometry.nodes(cell)));
      });
      nodal->finish_sum();
      for (unsigned int node = 0; node < n_owned_nodes; ++node)
        {
          double *values = nodal->at(node);
          if (values[Value::dense_volume] > 0.)
            values[Value::dense_rate] /= values[Value::dense_volume];
        }
      if (overfull)
        {
          overfull->compute(blocks, sums);
          for (unsigned int node = 0; node < n_owned_nodes; ++node)
            nodal->at(node)[Value::dense_rate] -=
              overfull->compaction_rate(node);
        }
      nodal->update_ghosts();
    }

    /// The average in 1/s at a cell that holds dense particles.
    double
    rate(const unsigned int cell) const
    {
      double sum = 0.;
      for (const unsigned int node : geometry.nodes(cell))
        sum += nodal->at(node)[Value::dense_rate];
      const double share = own[cell].share;
      return share * sum / n_nodes + (1. - share) * own_rate(cell);
    }

    /// What separated particles of a cell take besides their own rate, in 1/s.
    double
    separated_compaction(const unsigned int cell) const
    {
      if (!overfull)
        return 0.;
      double sum = 0.;
      for (const unsigned int node : geometry.nodes(cell))
        sum += overfull->compaction_rate(node);
      return sum / n_nodes;
    }

    /// The mean of its dense particles, in 1/s.
    double
    own_rate(const unsigned int cell) const
    {
      return own[cell].rate;
    }

    /// Change of the rates in the last compute(), see NodalSums::rate_change().
    RateChange
    rate_change(const unsigned int cell) const
    {
      if constexpr (Setting::has_uniform_strain)
        return {};
      else
        return rate_changes[cell];
    }

    const bool is_on;

    /// Smallest density of particles that count, in kg/m^3.
    const double smallest_density;

    /// Sums at the particles' present positions; none if averaging is off, or
    /// if all particles of a cell have its rate.
    std::unique_ptr<Sums> cells;

    /// None unless overfull cells are relieved.
    std::unique_ptr<OverfullCells<Setting>> overfull;

  private:
    /// Of the cells around a node.
    enum Value : unsigned int
    {
      dense_volume, ///< in m^3
      dense_rate,   ///< the mean in 1/s; before the division, times the volume
      n_values
    };

    /// Share of its cell that a particle fills where four of them fill it.
    static constexpr double smallest_filled_share = 0.25;

    void
    add_to_nodes(const unsigned int              cell,
                 const NodalSums<Setting>       &sums,
                 const CellValues<dim, n_nodes> &velocities)
    {
      if constexpr (!Setting::has_uniform_strain)
        rate_changes[cell] = sums.rate_change(cell, velocities);
      const double volume = sums.dense_volume(cell);
      if (!(volume > 0.)) // all are separated
        return;
      const double rate = mean_rate(cell, sums, velocities);
      const double share =
        std::min(1., sums.share_filled(cell) / smallest_filled_share);
      own[cell]           = {rate, share};
      const double weight = share * volume;
      for (const unsigned int node : geometry.nodes(cell))
        {
          nodal->at(node)[Value::dense_volume] += weight;
          nodal->at(node)[Value::dense_rate] += weight * rate;
        }
    }

    /// What a filled cell brings along.
    struct OwnRate
    {
      double rate;  ///< the mean of its particles, in 1/s
      double share; ///< alpha, of the average in what it takes
    };

    /// Of a cell's dense particles, in 1/s.
    double
    mean_rate(const unsigned int              cell,
              const NodalSums<Setting>       &sums,
              const CellValues<dim, n_nodes> &velocities) const
    {
      const auto &shape = geometry.shape(cell);
      if constexpr (Setting::has_uniform_strain)
        return trace(gradient_of(velocities, shape.shape_gradients({})));
      else
        {
          const double volume =
            sums[cell].values[CellSums<Setting, double>::dense_volume];
          return (*cells)[cell].rate_times_volume(shape, volume, velocities) /
                   volume +
                 rate_changes[cell].volumetric();
        }
    }

    const Geometry                       &geometry;
    const unsigned int                    n_owned_nodes;
    std::unique_ptr<NodalField<n_values>> nodal;
    std::vector<OwnRate>                  own;
    /// Change of the rates in each filled cell, unless strain is uniform.
    std::vector<RateChange> rate_changes;
  };
} // namespace Sandglass

#endif
