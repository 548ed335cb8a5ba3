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
   * volume of their stressed particles, then the mean of the cell's nodes.
   *
   * With the elastic law p = -K theta this is the average nodal pressure
   * element of Bonet and Burton (1998): the averaging is symmetric with respect
   * to the weights, so the stiffness matrix stays symmetric, and with
   * eigenvalues between 0 and 1, so the critical time step does not become
   * shorter.
   *
   * Particles less dense than `smallest_density` carry no stress and don't
   * count. Those that are hardly less dense have only just loosened and will
   * resist again soon. Where material flows so fast that this is the rule, they
   * take an average of their own, over all particles that are not separated.
   * With their cell's rate they would loosen where that errs to one side and
   * become dense where it errs to the other, so that the stressed ones would be
   * those whose cells seem to contract, and their pressure would rise as if the
   * cells locked. To let the stressed ones count the loosened ones too would
   * make the stiffness unsymmetric, and shake loose material. Where pressure is
   * high beside rho v^2, such an average would drive the waves that run through
   * a silo when its outlet opens (doc/tried.md).
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

    /// @param smallest_density  of stressed particles, in kg/m^3.
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
      cells = std::make_unique<Sums>(geometry, smallest_density);
      nodal = std::make_unique<NodalField<n_values>>(nodes);
      if constexpr (!Setting::has_uniform_strain)
        rate_changes.resize(geometry.n_cells());
    }

    /**
     * Find the averages for a velocity field with its ghosts. Collective; does
     * nothing if it is off.
     *
     * @param sums  of the particles' present positions, as `cells` are. What
     *              counts as stiff there is not separated.
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
        const auto &nodes      = geometry.nodes(cell);
        const auto  velocities = gather(velocity, nodes);
        if constexpr (!Setting::has_uniform_strain)
          rate_changes[cell] = sums.rate_change(cell, velocities);

        add_to_nodes(cell, sums.cells[cell], velocities);
      });
      nodal->finish_sum();
      for (unsigned int node = 0; node < n_owned_nodes; ++node)
        {
          double *values = nodal->at(node);
          values[Value::dense_volume] += values[Value::stressed_volume];
          values[Value::dense_rate] += values[Value::stressed_rate];
          if (values[Value::stressed_volume] > 0.)
            values[Value::stressed_rate] /= values[Value::stressed_volume];
          if (values[Value::dense_volume] > 0.)
            {
              values[Value::dense_rate] /= values[Value::dense_volume];
              values[Value::pressure] /= values[Value::dense_volume];
            }
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double component = velocity.at(node)[d];
              values[Value::pressure] -= largest_pressure_over_inertia *
                                         smallest_density * component *
                                         component;
            }
        }
      nodal->update_ghosts();
    }

    /// The average in 1/s at a cell that holds stressed particles.
    double
    rate(const unsigned int cell) const
    {
      return mean_of_nodes(cell, Value::stressed_rate);
    }

    /// Whether some of a cell's particles have only just loosened and follow
    /// rate_of_loosened(): where there is stress in their cell or its
    /// neighbours, but not more than inertia can bring about.
    ///
    /// @param sums  as compute() takes them.
    bool
    has_loosened(const unsigned int cell, const NodalSums<Setting> &sums) const
    {
      return sums.cells[cell].values[SumsOfCell::stiff_volume] >
               volume_of_stressed(cell) &&
             mean_of_nodes(cell, Value::stressed_volume) > 0. &&
             mean_of_nodes(cell, Value::pressure) < 0.;
    }

    /// The average in 1/s at a cell that holds such particles.
    double
    rate_of_loosened(const unsigned int cell) const
    {
      return mean_of_nodes(cell, Value::dense_rate);
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

    /// Smallest density of stressed particles, in kg/m^3.
    const double smallest_density;

    /// Sums at the particles' present positions; none if averaging is off.
    std::unique_ptr<Sums> cells;

  private:
    /// Two means over the cells around a node: of stressed particles, and of
    /// all that are not separated; volumes in m^3, rates in 1/s.
    enum Value : unsigned int
    {
      stressed_volume,
      stressed_rate, ///< before the division, times the volume
      dense_volume,  ///< until all cells are added, of the loosened only
      dense_rate,    ///< likewise
      pressure,      ///< less the largest with which they loosen, in Pa
      n_values
    };

    using SumsOfCell = CellSums<Setting, double>;

    /// Largest pressure over rho v^2 where loosened particles take an average.
    static constexpr double largest_pressure_over_inertia = 10.;

    void
    add_to_nodes(const unsigned int              cell,
                 const SumsOfCell               &sums,
                 const CellValues<dim, n_nodes> &velocities)
    {
      const auto  &shape    = geometry.shape(cell);
      const double stressed = volume_of_stressed(cell);
      const double loosened = sums.values[SumsOfCell::stiff_volume] - stressed;
      double       rate_times_volume =
        (*cells)[cell].rate_times_volume(shape, velocities);
      if constexpr (!Setting::has_uniform_strain)
        rate_times_volume += stressed * rate_changes[cell].volumetric();
      // The normal stresses are the first ones.
      double pressure_times_volume = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        pressure_times_volume -= sums.values[SumsOfCell::stress + d] / dim;
      const auto &nodes = geometry.nodes(cell);
      for (const unsigned int node : nodes)
        {
          nodal->at(node)[Value::stressed_volume] += stressed;
          nodal->at(node)[Value::stressed_rate] += rate_times_volume;
          nodal->at(node)[Value::pressure] += pressure_times_volume;
        }
      if (!(loosened > 0.)) // as in most cells
        return;
      const double loosened_rate = rate_at_mean_point(shape, sums, velocities) +
                                   rate_change(cell).volumetric();
      for (const unsigned int node : nodes)
        {
          nodal->at(node)[Value::dense_volume] += loosened;
          nodal->at(node)[Value::dense_rate] += loosened * loosened_rate;
        }
    }

    double
    volume_of_stressed(const unsigned int cell) const
    {
      return (*cells)[cell].values[VolumetricSums<Setting, double>::volume];
    }

    /// The volumetric rate of v^L in 1/s where the mean of a cell's particles
    /// is. The mean rate of those without stress differs from it by little.
    static double
    rate_at_mean_point(const typename Setting::Shape  &shape,
                       const SumsOfCell               &sums,
                       const CellValues<dim, n_nodes> &velocities)
    {
      if constexpr (Setting::has_uniform_strain)
        return trace(gradient_of(velocities, shape.shape_gradients({})));
      else
        {
          const auto point = sums.mean_point();
          double     result =
            trace(gradient_of(velocities, shape.shape_gradients(point)));
          if constexpr (Setting::has_hoop_strain)
            result +=
              interpolate(velocities, Setting::Shape::shape_values(point))[0] /
              shape.to_real(point_of(point))[0];
          return result;
        }
    }

    double
    mean_of_nodes(const unsigned int cell, const unsigned int value) const
    {
      double sum = 0.;
      for (const unsigned int node : geometry.nodes(cell))
        sum += nodal->at(node)[value];
      return sum / n_nodes;
    }

    const Geometry                       &geometry;
    const unsigned int                    n_owned_nodes;
    std::unique_ptr<NodalField<n_values>> nodal;
    /// Change of the rates in each filled cell, unless strain is uniform.
    std::vector<RateChange> rate_changes;
  };
} // namespace Sandglass

#endif
