#ifndef sandglass_flow_particle_in_cell_volumetric_sums_h
#define sandglass_flow_particle_in_cell_volumetric_sums_h

#include <sandglass/flow/particle_in_cell/cell_kernel.h>
#include <sandglass/flow/particle_in_cell/is_dense.h>

namespace Sandglass
{
  /**
   * What VolumetricAverage needs to know of a cell's dense particles besides
   * their volume, where their rates differ: this volume times the change of
   * volume that the velocities of the cell's nodes cause. The rate is linear in
   * these velocities, with the weights dN_i/dx_d, and also N_i / x for the hoop
   * rate; the weights' sums over the particles suffice for any velocities.
   *
   * @tparam Number  Lanes while blocks are added, double for their sum.
   */
  template <typename Setting, typename Number>
  class VolumetricSums
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    static constexpr int          dim     = Setting::dim;

    using Shape  = typename Setting::Shape;
    using State  = ParticleState<typename Setting::Layout, Number>;
    using Vector = typename Setting::template Vector<Number>;

    /// Places of the sums in `values`.
    enum Sum : unsigned int
    {
      weights = 0, ///< of the nodes' velocities, in m^2
      n_sums  = Setting::has_constant_gradients ? n_nodes : dim * n_nodes
    };

    std::array<Number, n_sums> values;

    void
    clear()
    {
      set_to_zero(values);
    }

    /// Add particles; those without mass, and separated ones, don't count.
    void
    add(const State &state, const double smallest_density, const Shape &shape)
    {
      const Number dense_volume =
        select(is_dense(state, smallest_density), state.volume(), Number(0.));
      if constexpr (!Setting::has_constant_gradients)
        {
          const auto gradients = shape.reference_gradients(state.reference);
          for (unsigned int d = 0; d < dim; ++d)
            {
              Vector direction;
              for (unsigned int e = 0; e < dim; ++e)
                direction[e] = dense_volume * gradients[e][d];
              const auto of_nodes =
                Shape::derivatives_along(direction, state.reference);
              for (unsigned int i = 0; i < n_nodes; ++i)
                values[weights + dim * i + d] += of_nodes[i];
            }
        }
      if constexpr (Setting::has_hoop_strain)
        {
          const auto   shape_values = Shape::shape_values(state.reference);
          const Number share        = dense_volume / state.location[0];
          for (unsigned int i = 0; i < n_nodes; ++i)
            values[radial_weight(i)] += share * shape_values[i];
        }
    }

    /// The particles' change of volume in m^3/s.
    ///
    /// @param volume      of the dense particles, in m^3.
    /// @param velocities  of the cell's nodes, in m/s.
    double
    rate_times_volume(const Shape                    &shape,
                      const double                    volume,
                      const CellValues<dim, n_nodes> &velocities) const
    {
      double result = 0.;
      if constexpr (Setting::has_constant_gradients)
        {
          const auto gradient =
            gradient_of(velocities,
                        shape.shape_gradients(
                          typename Setting::template Vector<>()));
          result = trace(gradient) * volume;
          if constexpr (Setting::has_hoop_strain)
            for (unsigned int i = 0; i < n_nodes; ++i)
              result += velocities[i][0] * values[radial_weight(i)];
        }
      else
        for (unsigned int i = 0; i < n_nodes; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            result += velocities[i][d] * values[weights + dim * i + d];
      return result;
    }

  private:
    static constexpr unsigned int
    radial_weight(const unsigned int i)
    {
      return weights + (Setting::has_constant_gradients ? i : dim * i);
    }
  };
} // namespace Sandglass

#endif
