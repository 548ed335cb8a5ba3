#ifndef sandglass_particle_stage_volumetric_average_h
#define sandglass_particle_stage_volumetric_average_h

#include <sandglass/particle_stage/deformation.h>

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
     */
    void
    compute(ParticleCloud         &cloud,
            const Geometry        &geometry,
            const NodalField<dim> &velocity)
    {
      if (!is_on)
        return;
      cells.clear();
      nodal->start_sum();
      for_each_filled_cell(cloud,
                           geometry,
                           [&](const unsigned int cell,
                               const Shape       &shape,
                               const auto        &nodes,
                               const auto        &particles) {
                             cells.push_back({cell, nodes});
                             add_cell(shape,
                                      nodes,
                                      gather(velocity, nodes),
                                      particles);
                           });
      nodal->finish_sum();
      nodal->update_ghosts();
      for (const Cell &cell : cells)
        rates[cell.index] = mean_of_nodes(cell.nodes);
    }

    /// The average in 1/s at a cell that holds stressed particles.
    double
    rate(const unsigned int cell) const
    {
      return rates[cell];
    }

    bool
    is_stressed(const double density) const
    {
      return density >= smallest_density;
    }

    const bool is_on;

  private:
    enum Sum : unsigned int
    {
      volume, ///< of stressed particles in the cells around the node, in m^3
      rate_times_volume,
      n_sums
    };

    struct Cell
    {
      unsigned int                      index;
      std::array<unsigned int, n_nodes> nodes;
    };

    template <typename ParticleRange>
    void
    add_cell(const Shape                             &shape,
             const std::array<unsigned int, n_nodes> &nodes,
             const CellValues<dim, n_nodes>          &velocities,
             const ParticleRange                     &particles)
    {
      std::array<double, n_sums> sums{};
      for (const auto &particle : particles)
        {
          const double *state   = particle.get_properties().data();
          const double  density = state[Property::density];
          if (!is_stressed(density))
            continue;
          const double volume = state[Property::mass] / density;
          sums[Sum::volume] += volume;
          sums[Sum::rate_times_volume] +=
            volume * volumetric_rate(shape,
                                     velocities,
                                     particle.get_reference_location(),
                                     particle.get_location()[0]);
        }
      CellValues<n_sums, n_nodes> contributions;
      contributions.fill(sums);
      scatter(contributions, nodes, *nodal);
    }

    static double
    volumetric_rate(const Shape                    &shape,
                    const CellValues<dim, n_nodes> &velocities,
                    const Point<dim>               &reference,
                    const double                    radius)
    {
      double rate =
        trace(gradient_of(velocities, shape.shape_gradients(reference)));
      if constexpr (Setting::has_hoop_strain)
        rate +=
          interpolate(velocities, Shape::shape_values(reference))[0] / radius;
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

    const double                        smallest_density;
    std::unique_ptr<NodalField<n_sums>> nodal;
    std::vector<Cell>                   cells; ///< that hold particles
    std::vector<double>                 rates; ///< of all cells
  };
} // namespace Sandglass

#endif
