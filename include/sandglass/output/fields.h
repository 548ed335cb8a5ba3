#ifndef sandglass_output_fields_h
#define sandglass_output_fields_h

#include <sandglass/output/vtu_file.h>
#include <sandglass/flow/particle_in_cell/particle_stage.h>

namespace Sandglass
{
  /// Number of layers into which the material's initial height is divided
  /// (paper, Figures 3, 4, 7 and 8).
  constexpr unsigned int n_layers = 16;

  /// The layer, 1 at the top to n_layers, of a point of the initial material.
  unsigned int
  layer_of(const Point<dim> &initial_position, const Scene &scene);

  /**
   * This rank's particles as dots. Displacements count from the position before
   * the static stage. All in SI units.
   */
  VtuPiece
  particle_fields(ParticleStage &stage);

  /**
   * This rank's cells with the nodal mass and the mapped velocity of the last
   * step, and the number of particles in each cell. All in SI units.
   */
  VtuPiece
  grid_fields(ParticleStage &stage);
} // namespace Sandglass

#endif
