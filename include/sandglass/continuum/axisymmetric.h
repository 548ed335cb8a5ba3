#ifndef sandglass_continuum_axisymmetric_h
#define sandglass_continuum_axisymmetric_h

#include <sandglass/continuum/in_plane.h>

namespace Sandglass
{
  /// A body of revolution about the axis x = 0, without rotation about it:
  /// results are those of the whole ring.
  struct Axisymmetric : InPlane
  {
    static constexpr Formulation formulation = Formulation::axisymmetric;

    static constexpr bool has_hoop_strain = true;

    static constexpr std::array<int, 4> force_components = {
      {Component::xx, Component::yy, Component::xy, Component::zz}};

    /// Length of the circle through a position, 2 pi x, in m.
    template <typename Position>
    static double
    measure(const Position &position)
    {
      constexpr double pi = 3.14159265358979323846;
      return 2. * pi * position[0];
    }
  };
} // namespace Sandglass

#endif
