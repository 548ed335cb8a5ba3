#ifndef sandglass_flow_particle_in_cell_nodal_fields_h
#define sandglass_flow_particle_in_cell_nodal_fields_h

#include <deal.II/base/partitioner.h>

#include <deal.II/lac/la_parallel_vector.h>


namespace Sandglass
{
  using namespace dealii;

  /**
   * A few numbers at each node of the grid, node by node in memory. Each rank
   * holds its own nodes and the ghost nodes of its cells.
   */
  template <std::size_t n_components>
  class NodalField
  {
  public:
    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// @param nodes  which nodes this rank owns and which are ghosts.
    explicit NodalField(const Utilities::MPI::Partitioner &nodes)
    {
      const auto expand = [](const IndexSet &set) {
        IndexSet expanded(set.size() * n_components);
        for (auto interval = set.begin_intervals();
             interval != set.end_intervals();
             ++interval)
          expanded.add_range(*interval->begin() * n_components,
                             (interval->last() + 1) * n_components);
        expanded.compress();
        return expanded;
      };
      values.reinit(expand(nodes.locally_owned_range()),
                    expand(nodes.ghost_indices()),
                    nodes.get_mpi_communicator());
    }

    /// The node's n_components numbers; `node` counts owned nodes, then ghosts.
    double *
    at(const unsigned int node)
    {
      return values.begin() + n_components * node;
    }

    const double *
    at(const unsigned int node) const
    {
      return values.begin() + n_components * node;
    }

    /// Set all to zero, ghosts included, before a sum over this rank's cells.
    void
    start_sum()
    {
      values = 0.;
    }

    /// Add what each rank has summed at its ghost nodes to their owners.
    void
    finish_sum()
    {
      values.compress(VectorOperation::add);
    }

    /// Give each rank the owners' values at its ghost nodes.
    void
    update_ghosts()
    {
      values.update_ghost_values();
    }

    /// The field as a vector with n_components entries a node, for deal.II's
    /// solvers.
    Vector &
    vector()
    {
      return values;
    }

  private:
    Vector values;
  };



  /// The sums over particles that steps 2 to 4 of Section 4.4 need.
  template <int dim>
  struct NodalSum
  {
    enum Component : unsigned int
    {
      mass           = 0,                    ///< lumped, in kg
      momentum       = 1,                    ///< in kg m/s
      internal_force = momentum + dim,       ///< R of eq. 9, in N
      own_mass       = internal_force + dim, ///< of M's diagonal, in kg
      stiffness      = own_mass + 1, ///< of stressed volume times modulus and
                                     ///< |dN_i/dx|^2, in N/m
      n_components = stiffness + 1
    };
  };

  template <int dim>
  using NodalSumField = NodalField<NodalSum<dim>::n_components>;



  /// All fields at the nodes that one step of Section 4.4 passes through.
  template <int dim>
  struct NodalFields
  {
    explicit NodalFields(const Utilities::MPI::Partitioner &nodes)
      : sums(nodes)
      , acceleration(nodes)
      , mapped_velocity(nodes)
    {}

    NodalSumField<dim> sums;
    NodalField<dim>    acceleration; ///< in m/s^2
    /// Momentum of the updated particles, then v^L of eq. 18 in m/s.
    NodalField<dim> mapped_velocity;
  };
} // namespace Sandglass

#endif
