#ifndef sandglass_continuum_formulation_h
#define sandglass_continuum_formulation_h

namespace Sandglass
{
  /**
   * How the section (x, y) that is computed extends to three dimensions:
   * unchanged along z (plane strain), or turned about the axis x = 0
   * (axisymmetric; x is the radius and the third direction the circumference);
   * or the grid has all three itself.
   */
  enum class Formulation
  {
    plane_strain,
    axisymmetric,
    three_dimensions
  };
} // namespace Sandglass

#endif
