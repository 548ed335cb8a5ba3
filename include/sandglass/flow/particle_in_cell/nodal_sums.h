#ifndef sandglass_flow_particle_in_cell_nodal_sums_h
#define sandglass_flow_particle_in_cell_nodal_sums_h

#include <sandglass/flow/particle_in_cell/cell_integration.h>
#include <sandglass/flow/particle_in_cell/sums_by_cell.h>

namespace Sandglass
{
  /**
   * Steps 2 to 4 of Section 4.4, the sums over particles: lumped nodal mass
   * M_I, nodal momentum S^T M_d V (eq. 11) and nodal internal force R (eq. 9;
   * axisymmetric with the hoop row N_i / x of B). The gravity force of step 4
   * is the nodal mass times gravity and needs no sum of its own.
   *
   * They come in two stages: the particles' sums in their cell, and the cells'
   * at the nodes.
   */
  template <typename Setting>
  class NodalSums
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    static constexpr int          dim     = Setting::dim;

    using Geometry = CellGeometry<Setting::cell_type>;
    using Blocks   = ParticleBlocks<typename Setting::Layout>;
    using NodalSum = Sandglass::NodalSum<dim>;

    /// @param smallest_stiff_density  of particles without stress that count as
    ///                                stiff, in kg/m^3.
    /// @param points  see CellIntegration.
    NodalSums(const Geometry                &geometry,
              const double                   smallest_stiff_density,
              const std::vector<Point<dim>> &points)
      : cells(geometry, smallest_stiff_density)
      , geometry(geometry)
      , integration(geometry, points)
    {}

    /**
     * The cells' sums at the nodes. Collective.
     *
     * @param modulus_of_cell  of uniaxial strain, in Pa, for NodalSum::own_mass
     *                         and stiffness; a null pointer leaves these 0.
     */
    template <typename ModulusOfCell>
    void
    scatter(const Blocks       &blocks,
            const ModulusOfCell modulus_of_cell,
            NodalSumField<dim> &sums) const
    {
      sums.start_sum();
      for_each_filled_cell_in_a_step(blocks, [&](const unsigned int cell) {
        const auto &nodes = geometry.nodes(cell);
        const auto &shape = geometry.shape(cell);
        const auto  force = integration.force(cell, cells[cell]);
        const auto  mass  = cells[cell].lumped_masses();
        for (unsigned int i = 0; i < n_nodes; ++i)
          {
            double *node_sums = sums.at(nodes[i]);
            node_sums[NodalSum::mass] += mass[i];
            for (unsigned int d = 0; d < dim; ++d)
              {
                node_sums[NodalSum::momentum + d] +=
                  cells[cell].momentum_at(i, d);
                node_sums[NodalSum::internal_force + d] += force[i][d];
              }
          }
        if constexpr (!std::is_same_v<ModulusOfCell, std::nullptr_t>)
          add_stiffness(cell, shape, nodes, modulus_of_cell(cell), sums);
      });
      sums.finish_sum();
    }

    /**
     * momentum = S^T M_d V of the particles after step 6, V += dt S a: the
     * momentum before the step plus dt M a with the consistent mass matrix.
     * Collective.
     */
    void
    map_momentum(const Blocks          &blocks,
                 const NodalField<dim> &acceleration,
                 const double           time_step,
                 NodalField<dim>       &momentum) const
    {
      momentum.start_sum();
      for_each_filled_cell_in_a_step(blocks, [&](const unsigned int cell) {
        const auto &nodes = geometry.nodes(cell);
        auto values       = cells[cell].mass_times(gather(acceleration, nodes));
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            values[i][d] =
              cells[cell].momentum_at(i, d) + time_step * values[i][d];
        Sandglass::scatter(values, nodes, momentum);
      });
      momentum.finish_sum();
    }

    /**
     * product += M field with the consistent mass matrix, without the exchange
     * between ranks.
     *
     * @return this rank's share of field^T M field.
     */
    double
    multiply_by_mass(const Blocks          &blocks,
                     const NodalField<dim> &field,
                     NodalField<dim>       &product) const
    {
      double energy = 0.;
      for_each_filled_cell_in_a_step(blocks, [&](const unsigned int cell) {
        const auto &cell_nodes = geometry.nodes(cell);
        const auto  values     = gather(field, cell_nodes);
        const auto  products   = cells[cell].mass_times(values);
        energy += scalar_product(products, values);
        Sandglass::scatter(products, cell_nodes, product);
      });
      return energy;
    }

    /// The volume in m^3 whose stiffness a cell has.
    double
    dense_volume(const unsigned int cell) const
    {
      return integration.volume(cell, cells[cell]);
    }

    /// See CellIntegration::share_filled().
    double
    share_filled(const unsigned int cell) const
    {
      return integration.share_filled(cell, cells[cell]);
    }

    /// The particles' sums in a cell.
    const CellSums<Setting, double> &
    operator[](const unsigned int cell) const
    {
      return cells[cell];
    }

    /// See CellIntegration::rate_change().
    typename CellIntegration<Setting>::RateChange
    rate_change(const unsigned int              cell,
                const CellValues<dim, n_nodes> &velocities) const
    {
      return integration.rate_change(cell, cells[cell], velocities);
    }

    /// The particles' sums in their cells.
    SumsByCell<Setting, CellSums> cells;

  private:
    using Shape = typename Setting::Shape;

    void
    add_stiffness(const unsigned int                       cell,
                  const Shape                             &shape,
                  const std::array<unsigned int, n_nodes> &nodes,
                  const double                             modulus,
                  NodalSumField<dim>                      &sums) const
    {
      const auto   gradients = shape.shape_gradients(point_within<Shape>());
      const double stiffness = modulus * dense_volume(cell);
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          double *node_sums = sums.at(nodes[i]);
          node_sums[NodalSum::own_mass] += cells[cell].mass_entry(i, i);
          node_sums[NodalSum::stiffness] +=
            stiffness * scalar_product(gradients[i], gradients[i]);
        }
    }

    const Geometry                &geometry;
    const CellIntegration<Setting> integration;
  };
} // namespace Sandglass

#endif
