#ifndef sandglass_tests_walls_of_scene_h
#define sandglass_tests_walls_of_scene_h

#include <deal.II/base/numbers.h>

#include <sandglass/scene/scene.h>
#include <sandglass/walls/section_tangent.h>
#include <sandglass/walls/wall_force.h>

#include <cmath>

/// Whether one of the scene's walls is of this role.
inline bool
is_role(const Sandglass::Scene<2>    &scene,
        const Sandglass::WallId       wall,
        const Sandglass::BoundaryRole role)
{
  return scene.walls[wall].role == role;
}

/// Of a wall on the material, in N; compression positive.
inline double
normal_force(const Sandglass::WallForce<2> &force)
{
  return -(force.force * force.normal);
}

/// Likewise along wall_tangent(): positive where it pushes material up.
inline double
tangential_force(const Sandglass::WallForce<2> &force)
{
  return force.force * Sandglass::wall_tangent(force.normal);
}

/// Of Coulomb friction at an angle in degrees.
inline double
friction_coefficient(const double angle)
{
  return std::tan(angle * dealii::numbers::PI / 180.);
}

#endif
