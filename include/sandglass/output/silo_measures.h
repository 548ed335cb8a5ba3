#ifndef sandglass_output_silo_measures_h
#define sandglass_output_silo_measures_h

#include <sandglass/scene/scene.h>

namespace Sandglass
{
  /// Lengths of the whole silo that formulas for silos ask for, in m.
  template <int dim>
  struct SiloMeasures
  {
    /// Taken from the faces of the scene's mesh.
    explicit SiloMeasures(const Scene<dim> &scene);

    /// Whether material can leave.
    bool has_open_outlet;

    /// Width or diameter of the outlet; 0 without one.
    double outlet_width;

    /// Middle of the outlet or, without an outlet, of the silo's bottom. If
    /// there is an axis, the point is on it.
    Point<dim> bottom_centre;
  };

  template <>
  SiloMeasures<2>::SiloMeasures(const Scene<2> &scene);
} // namespace Sandglass

#endif
