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

    /// Width or diameter of the outlet, in three dimensions the smaller of its
    /// lengths along x and z; 0 without one.
    double outlet_width;

    /// Whether the outlet goes on along z for ever, or from wall to wall.
    bool has_slot;

    /// Middle of the outlet or, without an outlet, of the silo's bottom. If
    /// there is an axis, the point is on it.
    Point<dim> bottom_centre;

    /// Beverloo's mass flow rate through the outlet (see beverloo.h), in kg/s;
    /// in plane strain per metre of depth.
    /// @param density     in kg/m^3
    /// @param gravity     in m/s^2
    /// @param grain_size  over outlet_width
    double
    beverloo_flow_rate(const double density,
                       const double gravity,
                       const double grain_size) const;

    /// In three dimensions, area of the outlet in m^2, and length of its lips
    /// in m.
    double outlet_area = 0., lip_length = 0.;
  };

  template <>
  SiloMeasures<2>::SiloMeasures(const Scene<2> &scene);

  template <>
  double
  SiloMeasures<2>::beverloo_flow_rate(const double density,
                                      const double gravity,
                                      const double grain_size) const;

  template <>
  SiloMeasures<3>::SiloMeasures(const Scene<3> &scene);

  template <>
  double
  SiloMeasures<3>::beverloo_flow_rate(const double density,
                                      const double gravity,
                                      const double grain_size) const;
} // namespace Sandglass

#endif
