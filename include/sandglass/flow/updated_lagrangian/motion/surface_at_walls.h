#ifndef sandglass_flow_updated_lagrangian_motion_surface_at_walls_h
#define sandglass_flow_updated_lagrangian_motion_surface_at_walls_h

#include <sandglass/flow/updated_lagrangian/motion/motion_setting.h>
#include <sandglass/flow/updated_lagrangian/rezoning/boundary_piece.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

namespace Sandglass
{
  /// Radians by which the free surface may turn in a point of a new mesh.
  inline constexpr double largest_turn_of_surface = 1.;

  /// Angles in radians between the free surface and what it meets, in the
  /// material or in the gap.
  struct SurfaceAngles
  {
    double at_walls;
    double at_axis; ///< a mirror: the surface goes on beyond it
  };

  /// Below these the surface is turned when the material is meshed anew.
  inline constexpr SurfaceAngles smallest_surface_angles{
    0.45,
    (numbers::PI - largest_turn_of_surface) / 2.};

  /// Below these the material is meshed anew.
  inline constexpr SurfaceAngles worst_surface_angles{0.2, 0.6};

  /**
   * Turn the free surface towards the walls that it meets at too small an
   * angle: beside a rough wall material lags behind, and its edge rolls over
   * into a tongue that lies along the wall or bends away from it.
   *
   * The surface's first pieces are replaced by a straight one, as few as make
   * the angle large enough, and the place where it meets the wall moves along
   * the wall so that the area stays the same. At the lip the surface leaves
   * the wall as it likes.
   *
   * @return how many places were changed.
   */
  unsigned int
  turn_surface_to_walls(BoundaryLoop        &loop,
                        const SurfaceAngles &smallest,
                        const MotionSetting &setting);

  /// Whether turn_surface_to_walls() would change the surface of a mesh.
  bool
  surface_leans_on_walls(const TriangleMesh  &mesh,
                         const SurfaceAngles &smallest,
                         const MotionSetting &setting);
} // namespace Sandglass

#endif
