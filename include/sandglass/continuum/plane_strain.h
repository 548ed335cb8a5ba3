#ifndef sandglass_continuum_plane_strain_h
#define sandglass_continuum_plane_strain_h

#include <sandglass/continuum/in_plane.h>

namespace Sandglass
{
  /// Plane strain: no strain along z, all results per metre of depth.
  struct PlaneStrain : InPlane
  {
    static constexpr Formulation formulation = Formulation::plane_strain;

    /// Whether there is a hoop strain u_x / x.
    static constexpr bool has_hoop_strain = false;

    /// Components of stress that do work, in the order in which sums over
    /// particles hold them.
    static constexpr std::array<int, 3> force_components = {
      {Component::xx, Component::yy, Component::xy}};

    /// Volume that a unit of the section's area stands for, in m.
    template <typename Position>
    static double
    measure(const Position &)
    {
      return 1.;
    }
  };
} // namespace Sandglass

#endif
