#ifndef sandglass_continuum_formulation_h
#define sandglass_continuum_formulation_h

namespace Sandglass
{
  /**
   * How the section (x, y) that is computed extends to three dimensions:
   * unchanged along z (plane strain), or turned about the axis x = 0
   * (axisymmetric; x is the radius and the third direction the circumference).
   */
  enum class Formulation
  {
    plane_strain,
    axisymmetric
  };
} // namespace Sandglass

#endif
