#ifndef sandglass_flow_particle_in_cell_volumetric_average_h
#define sandglass_flow_particle_in_cell_volumetric_average_h

#include <sandglass/flow/particle_in_cell/nodal_sums.h>
#include <sandglass/flow/particle_in_cell/volumetric_sums.h>

#include <memory>
#include <vector>

namespace Sandglass
{
  /**
   * The volumetric deformation rate of each cell, averaged over its
   * neighbourhood, against the locking of linear cells under plastic flow that
   * keeps the volume: first the mean of the cells at each node, weighted by the
   * volume of their dense particles, then the mean of the cell's nodes.
   *
   * With the elastic law p = -K theta this is the average nodal pressure
   * element of Bonet and Burton (1998): the averaging is symmetric with respect
   * to the weights, so the stiffness matrix stays symmetric, and with
   * eigenvalues between 0 and 1, so the critical time step does not become
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
    SANDGLASS_OWN_FUNCTION void
    compute(const Blocks             &blocks,
            const NodalSums<Setting> &sums,
            const NodalField<dim>    &velocity)
    {
      if (!is_on)
        return;
      nodal->start_sum();
      for_each_filled_cell(blocks, [&](const unsigned int cell) {
        add_to_nodes(cell, sums, gather(velocity, geometry.nodes(cell)));
      });
      nodal->finish_sum();
      for (unsigned int node = 0; node < n_owned_nodes; ++node)
        {
          double *values = nodal->at(node);
          if (values[Value::dense_volume] > 0.)
            values[Value::dense_rate] /= values[Value::dense_volume];
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
      return sum / n_nodes;
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

  private:
    /// Of the cells around a node.
    enum Value : unsigned int
    {
      dense_volume, ///< in m^3
      dense_rate,   ///< the mean in 1/s; before the division, times the volume
      n_values
    };

    void
    add_to_nodes(const unsigned int              cell,
                 const NodalSums<Setting>       &sums,
                 const CellValues<dim, n_nodes> &velocities)
    {
      const auto  &shape = geometry.shape(cell);
      const double volume =
        sums.cells[cell].values[CellSums<Setting, double>::dense_volume];
      double rate_times_volume;
      if constexpr (Setting::has_uniform_strain)
        rate_times_volume =
          volume * trace(gradient_of(velocities, shape.shape_gradients({})));
      else
        {
          rate_changes[cell] = sums.rate_change(cell, velocities);
          rate_times_volume =
            (*cells)[cell].rate_times_volume(shape, volume, velocities) +
            volume * rate_changes[cell].volumetric();
        }
      for (const unsigned int node : geometry.nodes(cell))
        {
          nodal->at(node)[Value::dense_volume] += volume;
          nodal->at(node)[Value::dense_rate] += rate_times_volume;
        }
    }

    const Geometry                       &geometry;
    const unsigned int                    n_owned_nodes;
    std::unique_ptr<NodalField<n_values>> nodal;
    /// Change of the rates in each filled cell, unless strain is uniform.
    std::vector<RateChange> rate_changes;
  };
} // namespace Sandglass

#endif
