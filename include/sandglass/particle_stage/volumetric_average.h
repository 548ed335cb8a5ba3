#ifndef sandglass_particle_stage_volumetric_average_h
#define sandglass_particle_stage_volumetric_average_h

#include <sandglass/base/instruction_sets.h>
#include <sandglass/particle_stage/nodal_sums.h>

#include <memory>
#include <vector>

namespace Sandglass
{
  /**
   * The volumetric deformation rate of each cell, averaged over its
   * neighbourhood, against the locking of linear cells under plastic flow that
   * keeps the volume: first the mean of the cells at each node, weighted by the
   * volume of their stressed particles, then the mean of the cell's nodes.
   *
   * With the elastic law p = -K theta this is the average nodal pressure
   * element of Bonet and Burton (1998): the averaging is symmetric with respect
   * to the weights, so the stiffness matrix stays symmetric, and with
   * eigenvalues between 0 and 1, so the critical time step does not become
   * shorter.
   *
   * Particles less dense than `smallest_density` are separated; they don't
   * count, and keep their own rate.
   */
  template <typename Setting>
  class VolumetricAverage
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    using Shape                           = CellShape<Setting::cell_type>;
    using Geometry                        = CellGeometry<Setting::cell_type>;

    /// @param smallest_density  of stressed particles, in kg/m^3.
    VolumetricAverage(const Utilities::MPI::Partitioner &nodes,
                      const unsigned int                 n_cells,
                      const double                       smallest_density,
                      const bool                         is_on)
      : is_on(is_on)
      , smallest_density(smallest_density)
    {
      if (!is_on)
        return;
      nodal = std::make_unique<NodalField<n_sums>>(nodes);
      rates.resize(n_cells);
    }

    /**
     * Find the averages for a velocity field with its ghosts. Collective; does
     * nothing if it is off.
     *
     * @param sums  of the particles' present positions.
     */
    void
    compute(const ParticleBlocks     &blocks,
            const Geometry           &geometry,
            const NodalSums<Setting> &sums,
            const NodalField<dim>    &velocity)
    {
      if (!is_on)
        return;
      nodal->start_sum();
      run_with_widest_vectors([&]() {
        for_each_filled_cell(blocks, [&](const unsigned int cell) {
          const auto &nodes      = geometry.nodes(cell);
          const auto  velocities = gather(velocity, nodes);
          double      change     = 0.;
          if constexpr (!Setting::has_uniform_strain)
            change = sums.rate_change(cell, velocities).volumetric();
          add_cell(
            blocks, cell, geometry.shape(cell), nodes, velocities, change);
        });
      });
      nodal->finish_sum();
      nodal->update_ghosts();
      for_each_filled_cell(blocks, [&](const unsigned int cell) {
        rates[cell] = mean_of_nodes(geometry.nodes(cell));
      });
    }

    /// The average in 1/s at a cell that holds stressed particles.
    double
    rate(const unsigned int cell) const
    {
      return rates[cell];
    }

    const bool is_on;

    /// Of stressed particles, in kg/m^3.
    const double smallest_density;

  private:
    enum Sum : unsigned int
    {
      volume, ///< of stressed particles in the cells around the node, in m^3
      rate_times_volume,
      n_sums
    };

    void
    add_cell(const ParticleBlocks                    &blocks,
             const unsigned int                       cell,
             const Shape                             &shape,
             const std::array<unsigned int, n_nodes> &nodes,
             const CellValues<dim, n_nodes>          &velocities,
             const double                             rate_change)
    {
      Lanes volumes(0.), rates_times_volumes(0.);
      blocks.for_each_block_in_cell(cell, [&](const unsigned int block) {
        const ParticleState<Lanes> state = load_state(blocks[block]);
        const Lanes volume = select(state.density >= Lanes(smallest_density),
                                    state.volume(),
                                    Lanes(0.));
        volumes += volume;
        rates_times_volumes +=
          volume *
          (volumetric_rate(shape, velocities, state) + Lanes(rate_change));
      });
      CellValues<n_sums, n_nodes> contributions;
      contributions.fill({{sum(volumes), sum(rates_times_volumes)}});
      scatter(contributions, nodes, *nodal);
    }

    static Lanes
    volumetric_rate(const Shape                    &shape,
                    const CellValues<dim, n_nodes> &velocities,
                    const ParticleState<Lanes>     &state)
    {
      const auto gradient =
        gradient_of(velocities, shape.shape_gradients(state.reference));
      Lanes rate = gradient[0][0] + gradient[1][1];
      if constexpr (Setting::has_hoop_strain)
        rate +=
          interpolate(velocities, Shape::shape_values(state.reference))[0] /
          state.location[0];
      return rate;
    }

    double
    mean_of_nodes(const std::array<unsigned int, n_nodes> &nodes) const
    {
      double sum = 0.;
      for (const unsigned int node : nodes)
        {
          const double *sums = nodal->at(node);
          if (sums[Sum::volume] > 0.)
            sum += sums[Sum::rate_times_volume] / sums[Sum::volume];
        }
      return sum / n_nodes;
    }

    std::unique_ptr<NodalField<n_sums>> nodal;
    std::vector<double>                 rates; ///< of all cells
  };
} // namespace Sandglass

#endif
