#ifndef sandglass_flow_particle_in_cell_setting_h
#define sandglass_flow_particle_in_cell_setting_h

#include <sandglass/particles/cell_shape.h>
#include <sandglass/particles/particle_layout.h>

namespace Sandglass
{
  /**
   * The compile-time choices of a run but for the law, of which only
   * LawAdapter knows more than how many numbers its state variables are. The
   * inner loops are templates on this class; choices.h lists what there is to
   * choose from.
   */
  template <typename Kinematics_,
            CellType     cell_type_,
            unsigned int n_state_numbers = 0>
  struct Setting
  {
    using Kinematics = Kinematics_;

    static constexpr CellType cell_type = cell_type_;
    static constexpr int      dim       = Kinematics::dim;

    using Shape = CellShape<cell_type>;
    static_assert(Shape::dim == dim);

    using Layout =
      ParticleLayout<dim, Kinematics::n_components, n_state_numbers>;

    /// A vector in space.
    template <typename Number = double>
    using Vector = std::array<Number, dim>;

    static constexpr unsigned int nodes_per_cell = Shape::n_nodes;

    /// Whether strain along the third direction exists (the hoop strain).
    static constexpr bool has_hoop_strain = Kinematics::has_hoop_strain;

    /// Whether the shape functions' gradients are constant in a cell.
    static constexpr bool has_constant_gradients = is_simplex(cell_type);

    /// Whether all particles of a cell deform alike.
    static constexpr bool has_uniform_strain =
      has_constant_gradients && !has_hoop_strain;
  };
} // namespace Sandglass

#endif
