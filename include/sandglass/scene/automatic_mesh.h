#ifndef sandglass_scene_automatic_mesh_h
#define sandglass_scene_automatic_mesh_h

#include <sandglass/scene/resolution.h>
#include <sandglass/scene/scene_parameters.h>

namespace Sandglass
{
  /// Particles in a cell where their number is `auto` but the cells' size is
  /// given: what scenes had before the program could choose.
  constexpr unsigned int particles_per_given_cell = 4;

  /// Bounds of Scene/Refinement, which is about steps of a mesh's size.
  constexpr double smallest_refinement = 0.1, largest_refinement = 10.;

  /// Height of empty cells above the material that such a mesh has, in m.
  double
  automatic_headroom(const SceneParameters &silo);

  /**
   * The mesh that suits a silo when its user says nothing, before refinement:
   * its cells at the outlet's lip are a share of the outlet's width, which
   * decides how exact the flow rate is (doc/graded-meshes.md), and resolve the
   * silo's own lengths elsewhere. Squares have one size, which grows where a
   * small outlet would cost too many of them; triangles are smaller for flat
   * hoppers where that costs little.
   *
   * Depends on the silo's lengths, formulation, cell type and gravity, and on
   * the speed of waves alone. Sizes have three digits, so that a parameter file
   * holds them exactly. A mesh file has its own cells: then only the number of
   * particles means something.
   *
   * @param wave_speed  of dilatational waves in the material, in m/s, on which
   *   the number of steps depends; 0: as if steps cost nothing.
   */
  Resolution
  automatic_resolution(const SceneParameters &silo, const double wave_speed);
} // namespace Sandglass

#endif
