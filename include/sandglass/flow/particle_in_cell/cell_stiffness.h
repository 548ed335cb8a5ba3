#ifndef sandglass_flow_particle_in_cell_cell_stiffness_h
#define sandglass_flow_particle_in_cell_cell_stiffness_h

#include <sandglass/flow/particle_in_cell/law_interface.h>

namespace Sandglass
{
  /**
   * The elastic stiffness K, the sum over stressed particles of V B^T C B, cell
   * by cell.
   *
   * Particles without stress that are less dense than `stiff_share` of the
   * unstressed material are separated; they don't count.
   *
   * C is the elasticity that the law is nowhere stiffer than: of all states, or
   * where it depends on the state, of the states in the cell.
   */
  template <typename Setting>
  class CellStiffness
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    static constexpr int          dim     = Setting::dim;

    using Kinematics = typename Setting::Kinematics;
    using Law        = LawInterface<Setting>;
    using State      = ParticleState<typename Setting::Layout, Lanes>;
    using Shape      = typename Setting::Shape;
    using Geometry   = CellGeometry<Setting::cell_type>;
    using Blocks     = ParticleBlocks<typename Setting::Layout>;
    using OfNodes    = CellValues<dim, n_nodes>;

    /// Both have to live as long as this object.
    CellStiffness(const Law &law, const Geometry &geometry)
      : law(law)
      , geometry(geometry)
      , of_cells(law.has_constant_stiffness ? 1 : geometry.n_cells(),
                 law.stiffness_bound())
    {
      if (!Setting::has_uniform_strain)
        matrices.resize(geometry.n_cells());
    }

    /// The elasticity C of a cell, as assemble() has found it last.
    const Elasticity &
    elasticity(const unsigned int cell) const
    {
      return of_cells[law.has_constant_stiffness ? 0 : cell];
    }

    /// Instead of assemble(), where a checkpoint tells it.
    void
    set_elasticity(const unsigned int cell, const Elasticity &stored)
    {
      of_cells[law.has_constant_stiffness ? 0 : cell] = stored;
    }

    /// Take the stiffness from the particles' positions.
    void
    assemble(const Blocks &blocks, const NodalSums<Setting> &cells)
    {
      if (!law.has_constant_stiffness)
        for_each_filled_cell(blocks, [&](const unsigned int cell) {
          of_cells[cell] = largest_stiffness(blocks, cell);
        });
      if constexpr (!Setting::has_uniform_strain)
        run_with_widest_vectors([&]() {
          for_each_cell_of_particles(blocks, [&](const unsigned int cell) {
            assemble(blocks, cells, cell);
          });
        });
    }

    /**
     * product += K field, without the exchange between ranks.
     *
     * @return this rank's share of field^T K field.
     */
    double
    multiply(const Blocks             &blocks,
             const NodalSums<Setting> &cells,
             const NodalField<dim>    &field,
             NodalField<dim>          &product) const
    {
      double energy = 0.;
      for_each_filled_cell(blocks, [&](const unsigned int cell) {
        const auto   &nodes         = geometry.nodes(cell);
        const OfNodes displacements = gather(field, nodes);
        OfNodes       forces;
        if constexpr (Setting::has_uniform_strain)
          forces = forces_of_uniform_strain(geometry.shape(cell),
                                            displacements,
                                            elasticity(cell),
                                            cells.dense_volume(cell));
        else
          as_vector(forces) = matrices[cell] * as_vector(displacements);
        energy += scalar_product(forces, displacements);
        scatter(forces, nodes, product);
      });
      return energy;
    }

  private:
    static constexpr int n_dofs = dim * n_nodes;
    using Matrix                = Eigen::Matrix<double, n_dofs, n_dofs>;
    using Vector                = Eigen::Matrix<double, n_dofs, 1>;
    /// For each pair of nodes i <= j: the effect on i of a displacement of j.
    using NodePairs = std::array<std::array<std::array<Lanes, dim>, dim>,
                                 n_nodes *(n_nodes + 1) / 2>;

    static Eigen::Map<Vector>
    as_vector(OfNodes &values)
    {
      return Eigen::Map<Vector>(values[0].data());
    }

    static Eigen::Map<const Vector>
    as_vector(const OfNodes &values)
    {
      return Eigen::Map<const Vector>(values[0].data());
    }

    /// The stiffest that the law is among a cell's particles.
    Elasticity
    largest_stiffness(const Blocks &blocks, const unsigned int cell) const
    {
      Elasticity largest(0., 0.);
      blocks.for_each_in_cell(cell, [&](const ParticleSlot &slot) {
        const Elasticity bound =
          law.stiffness_bound(load_state(blocks[slot.block], slot.lane));
        largest.lame_modulus =
          std::max(largest.lame_modulus, bound.lame_modulus);
        largest.shear_modulus =
          std::max(largest.shear_modulus, bound.shear_modulus);
      });
      return largest;
    }

    OfNodes
    forces_of_uniform_strain(const Shape      &shape,
                             const OfNodes    &displacements,
                             const Elasticity &elasticity,
                             const double      volume) const
    {
      const auto gradients =
        shape.shape_gradients(typename Setting::template Vector<>());
      const typename Kinematics::template Increment<double> increment(
        gradient_of(displacements, gradients), 0.);
      const auto stress = (volume * elasticity.stress(increment.strain)).eval();
      std::array<double, Kinematics::force_components.size()> of_forces;
      for (unsigned int k = 0; k < of_forces.size(); ++k)
        of_forces[k] = stress[Kinematics::force_components[k]];
      OfNodes forces;
      for (unsigned int i = 0; i < n_nodes; ++i)
        forces[i] = Kinematics::nodal_force(of_forces.data(), gradients[i]);
      return forces;
    }

    void
    assemble(const Blocks             &blocks,
             const NodalSums<Setting> &cells,
             const unsigned int        cell)
    {
      NodePairs pairs;
      for (auto &pair : pairs)
        for (auto &row : pair)
          row.fill(Lanes(0.));
      blocks.for_each_block_in_cell(cell, [&](const unsigned int block) {
        add_particles(load_state(blocks[block]),
                      cells.cells.smallest_density,
                      geometry.shape(cell),
                      elasticity(cell),
                      pairs);
      });

      const double of_particles =
        cells[cell].values[CellSums<Setting, double>::dense_volume];
      const double factor =
        of_particles > 0. ? cells.dense_volume(cell) / of_particles : 1.;
      auto pair = pairs.begin();
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int j = i; j < n_nodes; ++j, ++pair)
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int e = 0; e < dim; ++e)
              matrices[cell](dim * i + d, dim * j + e) =
                matrices[cell](dim * j + e, dim * i + d) =
                  factor * sum((*pair)[d][e]);
    }

    /**
     * V B^T C B for particles side by side: in terms of the nodes' shape
     * functions N, their gradients g and h = N / x, and with t = g, to which h
     * is added in x, for the trace of the strain, it is the sum of lambda t_i
     * t_j^T, G g_j g_i^T, G g_i . g_j on the diagonal, and 2 G h_i h_j for x.
     */
    void
    add_particles(const State      &state,
                  const double      smallest_density,
                  const Shape      &shape,
                  const Elasticity &elasticity,
                  NodePairs        &pairs) const
    {
      const auto  gradients = shape.shape_gradients(state.reference);
      const Lanes volume =
        select(is_dense(state, smallest_density), state.volume(), Lanes(0.));
      const Lanes lame  = volume * elasticity.lame_modulus;
      const Lanes shear = volume * elasticity.shear_modulus;

      std::array<std::array<Lanes, dim>, n_nodes> traces;
      std::array<Lanes, n_nodes>                  hoop;
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          traces[i][d] = Lanes(gradients[i][d]);
      if constexpr (Setting::has_hoop_strain)
        {
          const auto  values     = Shape::shape_values(state.reference);
          const Lanes per_radius = Lanes(1.) / state.location[0];
          for (unsigned int i = 0; i < n_nodes; ++i)
            {
              hoop[i] = values[i] * per_radius;
              traces[i][0] += hoop[i];
            }
        }

      auto pair = pairs.begin();
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int j = i; j < n_nodes; ++j, ++pair)
          {
            auto product = gradients[i][0] * gradients[j][0];
            for (unsigned int d = 1; d < dim; ++d)
              product += gradients[i][d] * gradients[j][d];
            const Lanes on_diagonal = shear * product;
            for (unsigned int d = 0; d < dim; ++d)
              {
                for (unsigned int e = 0; e < dim; ++e)
                  (*pair)[d][e] += lame * traces[i][d] * traces[j][e] +
                                   shear * gradients[i][e] * gradients[j][d];
                (*pair)[d][d] += on_diagonal;
              }
            if constexpr (Setting::has_hoop_strain)
              (*pair)[0][0] += 2. * shear * hoop[i] * hoop[j];
          }
    }

    const Law              &law;
    const Geometry         &geometry;
    std::vector<Elasticity> of_cells; ///< one, if all cells have the same
    std::vector<Matrix> matrices; ///< of each cell, unless strain is uniform
  };
} // namespace Sandglass

#endif
