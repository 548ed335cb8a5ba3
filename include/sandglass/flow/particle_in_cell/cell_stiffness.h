#ifndef sandglass_flow_particle_in_cell_cell_stiffness_h
#define sandglass_flow_particle_in_cell_cell_stiffness_h

#include <sandglass/base/symmetric_matrix.h>
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
      for_each_filled_cell_in_a_step(blocks, [&](const unsigned int cell) {
        const auto   &nodes         = geometry.nodes(cell);
        const OfNodes displacements = gather(field, nodes);
        OfNodes       forces;
        if constexpr (Setting::has_uniform_strain)
          forces = forces_of_uniform_strain(geometry.shape(cell),
                                            displacements,
                                            elasticity(cell),
                                            cells.dense_volume(cell));
        else
          matrices[cell].multiply(displacements[0].data(), forces[0].data());
        energy += scalar_product(forces, displacements);
        scatter(forces, nodes, product);
      });
      return energy;
    }

  private:
    using Matrix = SymmetricMatrix<dim * n_nodes>;
    /// A node's gradient g, and with hoop strain h = N / x as one more number.
    static constexpr unsigned int n_of_node =
      dim + (Setting::has_hoop_strain ? 1 : 0);
    static constexpr unsigned int n_of_pair = n_of_node * n_of_node;
    /// The products of these numbers times volume, summed over particles, for
    /// each pair of nodes i <= j: those of i run last.
    template <typename Number>
    using Products = std::array<Number, n_nodes *(n_nodes + 1) / 2 * n_of_pair>;

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
      Products<Lanes> of_lanes;
      of_lanes.fill(Lanes(0.));
      blocks.for_each_block_in_cell(cell, [&](const unsigned int block) {
        add_particles(load_state(blocks[block]),
                      cells.cells.smallest_density,
                      geometry.shape(cell),
                      of_lanes);
      });
      Products<double> products;
      sum_lanes(of_lanes, products);

      const double of_particles =
        cells[cell].values[CellSums<Setting, double>::dense_volume];
      const double factor =
        of_particles > 0. ? cells.dense_volume(cell) / of_particles : 1.;
      Matrix       &matrix = matrices[cell];
      const double *pair   = products.data();
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int j = i; j < n_nodes; ++j, pair += n_of_pair)
          {
            const auto stiffness = stiffness_of_pair(pair, elasticity(cell));
            for (unsigned int d = 0; d < dim; ++d)
              for (unsigned int e = i == j ? d : 0; e < dim; ++e)
                matrix.set(dim * i + d, dim * j + e, factor * stiffness[d][e]);
          }
    }

    void
    add_particles(const State     &state,
                  const double     smallest_density,
                  const Shape     &shape,
                  Products<Lanes> &products) const
    {
      std::array<std::array<Lanes, n_of_node>, n_nodes> of_nodes;
      const auto gradients = shape.shape_gradients(state.reference);
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          of_nodes[i][d] = Lanes(gradients[i][d]);
      if constexpr (Setting::has_hoop_strain)
        {
          const auto  values     = Shape::shape_values(state.reference);
          const Lanes per_radius = Lanes(1.) / state.location[0];
          for (unsigned int i = 0; i < n_nodes; ++i)
            of_nodes[i][dim] = values[i] * per_radius;
        }

      const Lanes volume =
        select(is_dense(state, smallest_density), state.volume(), Lanes(0.));
      Lanes *product = products.data();
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          std::array<Lanes, n_of_node> of_i;
          for (unsigned int d = 0; d < n_of_node; ++d)
            of_i[d] = volume * of_nodes[i][d];
          for (unsigned int j = i; j < n_nodes; ++j)
            for (unsigned int d = 0; d < n_of_node; ++d)
              for (unsigned int e = 0; e < n_of_node; ++e)
                *product++ += of_i[d] * of_nodes[j][e];
        }
    }

    /**
     * The effect on node i of a displacement of node j, a part of V B^T C B: in
     * terms of g and h, and with t = g, to which h is added in x, for the trace
     * of the strain, it is the sum of lambda t_i t_j^T, G g_j g_i^T, G g_i .
     * g_j on the diagonal, and 2 G h_i h_j for x.
     *
     * @param products  of this pair.
     */
    static std::array<std::array<double, dim>, dim>
    stiffness_of_pair(const double *products, const Elasticity &elasticity)
    {
      const double lame  = elasticity.lame_modulus;
      const double shear = elasticity.shear_modulus;
      const auto   at = [products](const unsigned int d, const unsigned int e) {
        return products[n_of_node * d + e];
      };
      double scalar_product = at(0, 0);
      for (unsigned int d = 1; d < dim; ++d)
        scalar_product += at(d, d);

      std::array<std::array<double, dim>, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          result[d][e] = lame * at(d, e) + shear * at(e, d);
      for (unsigned int d = 0; d < dim; ++d)
        result[d][d] += shear * scalar_product;
      if constexpr (Setting::has_hoop_strain)
        {
          for (unsigned int d = 0; d < dim; ++d)
            {
              result[d][0] += lame * at(d, dim);
              result[0][d] += lame * at(dim, d);
            }
          result[0][0] += (lame + 2. * shear) * at(dim, dim);
        }
      return result;
    }

    const Law              &law;
    const Geometry         &geometry;
    std::vector<Elasticity> of_cells; ///< one, if all cells have the same
    std::vector<Matrix> matrices; ///< of each cell, unless strain is uniform
  };
} // namespace Sandglass

#endif
