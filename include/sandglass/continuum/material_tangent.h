#ifndef sandglass_continuum_material_tangent_h
#define sandglass_continuum_material_tangent_h

#include <sandglass/continuum/symmetric_components.h>

namespace Sandglass
{
  /// Derivatives of the stress at the end of an increment.
  template <int n>
  struct MaterialTangent
  {
    /// With respect to the turned stress at the increment's start.
    ComponentMatrix<n> by_stress;
    /// With respect to the increment's strain, in Pa.
    ComponentMatrix<n> by_strain;
  };
} // namespace Sandglass

#endif
