#ifndef sandglass_tests_wall_role_h
#define sandglass_tests_wall_role_h

#include <sandglass/scene/boundary_role.h>
#include <sandglass/walls/wall.h>
#include <sandglass/walls/wall_force.h>

/// Whether a wall is the one with this role, in a silo that has one of each.
inline bool
is_role(const Sandglass::WallId wall, const Sandglass::BoundaryRole role)
{
  return wall == Sandglass::boundary_id(role);
}

/// The same for the wall of a force in the state at rest.
inline bool
is_role(const Sandglass::WallForce<2> &force,
        const Sandglass::BoundaryRole  role)
{
  return force.role == role;
}

#endif
