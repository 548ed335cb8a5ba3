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
        for_each_filled_cell(blocks, [&](const unsigned int cell) {
          matrices[cell].setZero();
          blocks.for_each_in_cell(cell, [&](const ParticleSlot &slot) {
            const auto state = load_state(blocks[slot.block], slot.lane);
            if (is_stiff(state, cells.cells.smallest_density))
              add_particle(state, geometry.shape(cell), matrices[cell]);
          });
          const double volume =
            cells[cell].values[CellSums<Setting, double>::stiff_volume];
          if (volume > 0.)
            matrices[cell] *= cells.stiff_volume(cell) / volume;
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
    using Gradients             = std::array<Pair<double>, n_nodes>;

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
      const Gradients gradients = shape.shape_gradients(Pair<double>());
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

    /// matrix += V B^T C B, with the strain's tensor components as B's rows.
    void
    add_particle(const ParticleState<double> &state,
                 const Shape                 &shape,
                 Matrix                      &matrix) const
    {
      const auto      values    = Shape::shape_values(state.reference);
      const Gradients gradients = shape.shape_gradients(state.reference);
      Eigen::Matrix<double, 4, n_dofs> strains, stresses;
      strains.setZero();
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          strains(Component::xx, dim * i)     = gradients[i][0];
          strains(Component::yy, dim * i + 1) = gradients[i][1];
          strains(Component::xy, dim * i)     = 0.5 * gradients[i][1];
          strains(Component::xy, dim * i + 1) = 0.5 * gradients[i][0];
          if constexpr (Setting::has_hoop_strain)
            strains(Component::zz, dim * i) = values[i] / state.location[0];
        }
      for (int k = 0; k < n_dofs; ++k)
        stresses.col(k) = elasticity.stress<double>(strains.col(k));
      stresses.row(Component::xy) *= 2.; // counts twice in strain : stress
      matrix += state.volume() * strains.transpose() * stresses;
    }

    const Elasticity    elasticity;
    const Geometry     &geometry;
    std::vector<Matrix> matrices; ///< of each cell, unless strain is uniform
  };
} // namespace Sandglass

#endif
