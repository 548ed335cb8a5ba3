#ifndef sandglass_walls_wall_h
#define sandglass_walls_wall_h

namespace Sandglass
{
  /// Number of a wall: an index into the scene's list of walls.
  using WallId = unsigned int;
} // namespace Sandglass

#endif
