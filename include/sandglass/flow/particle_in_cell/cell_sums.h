#ifndef sandglass_flow_particle_in_cell_cell_sums_h
#define sandglass_flow_particle_in_cell_cell_sums_h

#include <sandglass/base/instruction_sets.h>
#include <sandglass/flow/particle_in_cell/cell_kernel.h>
#include <sandglass/flow/particle_in_cell/is_dense.h>
#include <sandglass/flow/particle_in_cell/setting.h>

namespace Sandglass
{
  /**
   * Steps 2 to 4 of Section 4.4, the particles' part: all that the nodes need
   * to know of a cell's particles, as sums over these.
   *
   * The cell's share of the consistent mass matrix M = S^T M_d S is kept, not
   * only that of the lumped one. With it the momentum S^T M_d V of step 7 is
   * that of step 2 plus dt M a, and one pass over the particles is enough for a
   * step.
   *
   * @tparam Number  Lanes while blocks are added, double for their sum.
   */
  template <typename Setting, typename Number>
  class CellSums
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    static constexpr int          dim     = Setting::dim;

    using Kinematics = typename Setting::Kinematics;
    using Shape      = typename Setting::Shape;
    using State      = ParticleState<typename Setting::Layout, Number>;
    using Vector     = typename Setting::template Vector<Number>;
    using OfNodes    = CellValues<dim, n_nodes>;

    static constexpr unsigned int n_force_components =
      Kinematics::force_components.size();

    /// Places of the sums in `values`.
    enum Sum : unsigned int
    {
      mass         = 0, ///< sum of m N_i N_j for i <= j, row by row, in kg
      momentum     = mass + n_nodes * (n_nodes + 1) / 2, ///< m N_i V, kg m/s
      dense_volume = momentum + dim * n_nodes, ///< of dense particles, m^3
      stress       = dense_volume + 1, ///< times volume, see force_components
      moment       = stress + n_force_components, ///< mean_point()
      force        = moment + (Setting::has_uniform_strain ? 0 : dim), ///< in N
      n_sums       = force + (Setting::has_uniform_strain     ? 0 :
                              Setting::has_constant_gradients ? n_nodes :
                                                                dim * n_nodes)
    };

    std::array<Number, n_sums> values;

    void
    clear()
    {
      set_to_zero(values);
    }

    /// Add particles; those without mass don't count.
    void
    add(const State &state, const double smallest_density, const Shape &shape)
    {
      const auto   shape_values = Shape::shape_values(state.reference);
      const Number volume       = state.volume();
      add_mass_and_momentum(state, shape_values);
      const Number volume_if_dense =
        select(is_dense(state, smallest_density), volume, Number(0.));
      values[dense_volume] += volume_if_dense;
      if constexpr (!Setting::has_uniform_strain)
        for (unsigned int d = 0; d < dim; ++d)
          values[moment + d] += volume_if_dense * state.reference[d];
      add_force(state, volume, shape_values, shape);
    }

    /// An entry of the consistent mass matrix, in kg.
    Number
    mass_entry(const unsigned int i, const unsigned int j) const
    {
      return values[mass_index(i, j)];
    }

    /// The diagonal of the lumped mass matrix, in kg: shape functions add up to
    /// 1.
    std::array<Number, n_nodes>
    lumped_masses() const
    {
      std::array<Number, n_nodes> result{};
      for_each_mass(
        [&](const unsigned int i, const unsigned int j, const Number &entry) {
          result[i] += entry;
          if (i != j)
            result[j] += entry;
        });
      return result;
    }

    /// Of all particles, in kg.
    Number
    total_mass() const
    {
      Number result(0.);
      for_each_mass(
        [&](const unsigned int i, const unsigned int j, const Number &entry) {
          result += i == j ? entry : 2. * entry;
        });
      return result;
    }

    /// The consistent mass matrix times nodal values.
    OfNodes
    mass_times(const OfNodes &nodal_values) const
    {
      OfNodes products{};
      for_each_mass(
        [&](const unsigned int i, const unsigned int j, const Number &entry) {
          for (unsigned int d = 0; d < dim; ++d)
            products[i][d] += entry * nodal_values[j][d];
          if (i != j)
            for (unsigned int d = 0; d < dim; ++d)
              products[j][d] += entry * nodal_values[i][d];
        });
      return products;
    }

    Number
    momentum_at(const unsigned int i, const unsigned int d) const
    {
      return values[momentum + dim * i + d];
    }

    /// Mean reference coordinates of the dense particles' volume.
    Vector
    mean_point() const
    {
      const Number per_volume = Number(1.) / values[dense_volume];
      Vector       point;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] = values[moment + d] * per_volume;
      return point;
    }

    /// Share of the internal force R (eq. 9) in N at each of the cell's nodes,
    /// integrated by the particles.
    OfNodes
    internal_force(const Shape &shape) const
    {
      OfNodes result;
      if constexpr (Setting::has_constant_gradients)
        {
          const auto gradients =
            shape.shape_gradients(typename Setting::template Vector<>());
          for (unsigned int i = 0; i < n_nodes; ++i)
            {
              result[i] =
                Kinematics::nodal_force(&values[stress], gradients[i]);
              if constexpr (Setting::has_hoop_strain)
                result[i][0] += values[force + i];
            }
        }
      else
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            result[i][d] = values[force + dim * i + d];
      return result;
    }

  private:
    static constexpr unsigned int
    mass_index(const unsigned int i, const unsigned int j)
    {
      return i <= j ? mass + i * n_nodes - i * (i + 1) / 2 + j :
                      mass + j * n_nodes - j * (j + 1) / 2 + i;
    }

    /// Call `function(i, j, entry)` for the upper triangle of the consistent
    /// mass matrix, as it is stored: loops over all of it spend more on finding
    /// the entries than on what they compute.
    template <typename Function>
    void
    for_each_mass(const Function &function) const
    {
      const Number *entry = &values[mass];
#pragma GCC unroll 4
      for (unsigned int i = 0; i < n_nodes; ++i)
#pragma GCC unroll 4
        for (unsigned int j = i; j < n_nodes; ++j)
          function(i, j, *entry++);
    }

    void
    add_mass_and_momentum(const State                       &state,
                          const std::array<Number, n_nodes> &shape_values)
    {
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          const Number share = state.mass * shape_values[i];
          for (unsigned int j = i; j < n_nodes; ++j)
            values[mass_index(i, j)] += share * shape_values[j];
          for (unsigned int d = 0; d < dim; ++d)
            values[momentum + dim * i + d] += share * state.velocity[d];
        }
    }

    /**
     * Where gradients are constant: stress times volume, which they multiply
     * later, and with hoop strain the part of the row N_i / x of B. Where they
     * are not constant: the force at each node.
     */
    void
    add_force(const State                       &state,
              const Number                      &volume,
              const std::array<Number, n_nodes> &shape_values,
              const Shape                       &shape)
    {
      std::array<Number, n_force_components> of_volume;
      for (unsigned int k = 0; k < n_force_components; ++k)
        {
          of_volume[k] = volume * state.stress[Kinematics::force_components[k]];
          values[stress + k] += of_volume[k];
        }
      Number hoop(0.);
      if constexpr (Setting::has_hoop_strain)
        hoop = of_volume.back() / state.location[0];

      if constexpr (Setting::has_constant_gradients)
        {
          if constexpr (Setting::has_hoop_strain)
            for (unsigned int i = 0; i < n_nodes; ++i)
              values[force + i] += hoop * shape_values[i];
        }
      else
        {
          const auto gradients = shape.reference_gradients(state.reference);
          std::array<Vector, dim> along;
          for (unsigned int e = 0; e < dim; ++e)
            along[e] = Kinematics::nodal_force(of_volume.data(), gradients[e]);
          for (unsigned int d = 0; d < dim; ++d)
            {
              Vector direction;
              for (unsigned int e = 0; e < dim; ++e)
                direction[e] = along[e][d];
              const auto of_nodes =
                Shape::derivatives_along(direction, state.reference);
              for (unsigned int i = 0; i < n_nodes; ++i)
                values[force + dim * i + d] += of_nodes[i];
            }
          if constexpr (Setting::has_hoop_strain)
            for (unsigned int i = 0; i < n_nodes; ++i)
              values[force + dim * i] += hoop * shape_values[i];
        }
    }
  };
} // namespace Sandglass

#endif
