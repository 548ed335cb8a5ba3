#ifndef sandglass_particle_stage_cell_stiffness_h
#define sandglass_particle_stage_cell_stiffness_h

#include <sandglass/material/elasticity.h>
#include <sandglass/particle_stage/deformation.h>
#include <sandglass/particle_stage/nodal_sums.h>

namespace Sandglass
{
  /**
   * The elastic stiffness K, the sum over stressed particles of V B^T C B, cell
   * by cell.
   *
   * Particles without stress that are less dense than `stiff_share` of the
   * unstressed material are separated; they don't count.
   */
  template <typename Setting>
  class CellStiffness
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    using Shape                           = CellShape<Setting::cell_type>;
    using Geometry                        = CellGeometry<Setting::cell_type>;
    using OfNodes                         = CellValues<dim, n_nodes>;

    static constexpr double stiff_share = 0.95;

    CellStiffness(const Elasticity &elasticity, const Geometry &geometry)
      : elasticity(elasticity)
      , geometry(geometry)
    {
      if (!Setting::has_uniform_strain)
        matrices.resize(geometry.n_cells());
    }

    /// Take the stiffness from the particles' positions.
    void
    assemble(const ParticleBlocks &blocks, const NodalSums<Setting> &cells)
    {
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
    multiply(const ParticleBlocks     &blocks,
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
                                            cells.stiff_volume(cell));
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
    /// For each pair of nodes i <= j what displacement of j does to i.
    using NodePairs =
      std::array<std::array<Pair<Lanes>, dim>, n_nodes *(n_nodes + 1) / 2>;

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

    OfNodes
    forces_of_uniform_strain(const Shape   &shape,
                             const OfNodes &displacements,
                             const double   volume) const
    {
      const auto gradients = shape.shape_gradients(Pair<double>());
      const DeformationIncrement<double> deformation(gradient_of(displacements,
                                                                 gradients),
                                                     0.);
      const SymmetricTensor4             stress =
        volume * elasticity.stress(deformation.strain);
      OfNodes forces;
      for (unsigned int i = 0; i < n_nodes; ++i)
        forces[i] = nodal_force(stress[Component::xx],
                                stress[Component::yy],
                                stress[Component::xy],
                                gradients[i]);
      return forces;
    }

    void
    assemble(const ParticleBlocks     &blocks,
             const NodalSums<Setting> &cells,
             const unsigned int        cell)
    {
      NodePairs pairs;
      for (auto &pair : pairs)
        pair.fill({{Lanes(0.), Lanes(0.)}});
      blocks.for_each_block_in_cell(cell, [&](const unsigned int block) {
        add_particles(load_state(blocks[block]),
                      cells.cells.smallest_density,
                      geometry.shape(cell),
                      pairs);
      });

      const double of_particles =
        cells[cell].values[CellSums<Setting, double>::stiff_volume];
      const double factor =
        of_particles > 0. ? cells.stiff_volume(cell) / of_particles : 1.;
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
     * functions N, their gradients g and h = N / x, and with t = (g_x + h, g_y)
     * for the trace of the strain, it is the sum of lambda t_i t_j^T,
     * G g_j g_i^T, G g_i . g_j on the diagonal, and 2 G h_i h_j for x.
     */
    void
    add_particles(const ParticleState<Lanes> &state,
                  const double                smallest_stiff_density,
                  const Shape                &shape,
                  NodePairs                  &pairs) const
    {
      const auto  gradients = shape.shape_gradients(state.reference);
      const Lanes volume    = select(is_stiff(state, smallest_stiff_density),
                                  state.volume(),
                                  Lanes(0.));
      const Lanes lame      = volume * elasticity.lame_modulus;
      const Lanes shear     = volume * elasticity.shear_modulus;

      std::array<Pair<Lanes>, n_nodes> traces;
      std::array<Lanes, n_nodes>       hoop;
      for (unsigned int i = 0; i < n_nodes; ++i)
        traces[i] = {{Lanes(gradients[i][0]), Lanes(gradients[i][1])}};
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
            const Lanes on_diagonal =
              shear * (gradients[i][0] * gradients[j][0] +
                       gradients[i][1] * gradients[j][1]);
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

    const Elasticity    elasticity;
    const Geometry     &geometry;
    std::vector<Matrix> matrices; ///< of each cell, unless strain is uniform
  };
} // namespace Sandglass

#endif
