#ifndef sandglass_base_setting_h
#define sandglass_base_setting_h

namespace Sandglass
{
  /// Space dimension of the grid and of the particles' positions.
  inline constexpr int dim = 2;

  /**
   * How the plane (x, y) extends to three dimensions: unchanged along z (plane
   * strain), or turned about the axis x = 0 (axisymmetric; x is the radius and
   * the third direction the circumference).
   */
  enum class Formulation
  {
    plane_strain,
    axisymmetric
  };

  /// Shape of the grid's cells.
  enum class CellType
  {
    triangle,
    quadrilateral
  };

  /**
   * The compile-time choices of a run. The inner loops are templates on this
   * class; it is chosen once, in source/run.cc.
   */
  template <Formulation formulation_, CellType cell_type_>
  struct Setting
  {
    static constexpr Formulation formulation = formulation_;
    static constexpr CellType    cell_type   = cell_type_;

    /// Whether strain along the third direction exists (the hoop strain).
    static constexpr bool has_hoop_strain =
      formulation == Formulation::axisymmetric;

    static constexpr unsigned int nodes_per_cell =
      cell_type == CellType::triangle ? 3 : 4;

    /// Whether the shape functions' gradients are constant in a cell.
    static constexpr bool has_constant_gradients =
      cell_type == CellType::triangle;

    /// Whether all particles of a cell deform alike.
    static constexpr bool has_uniform_strain =
      has_constant_gradients && !has_hoop_strain;
  };
} // namespace Sandglass

#endif
