#ifndef sandglass_output_particle_fields_h
#define sandglass_output_particle_fields_h

#include <sandglass/base/table.h>
#include <sandglass/flow/flow_view.h>
#include <sandglass/output/vtu_file.h>

#include <vector>

namespace Sandglass
{
  /// The layers into which the material's initial height is divided (paper,
  /// Figures 3, 4, 7 and 8).
  struct Layers
  {
    static constexpr unsigned int n = 16;

    double fill_bottom, fill_top; ///< in m

    /// The layer, 1 at the top to n, of a point of the initial material.
    unsigned int
    of(const Point<3> &initial_location) const;
  };

  /// What a particle's fields are read from.
  struct ParticleInLayers
  {
    const ParticleRecord &particle;
    const Layers         &layers;
  };

  /// Fields of particles.pvd, before the law's state variables.
  extern const std::vector<Field<ParticleInLayers>> particle_table;

  /// This rank's particles as dots.
  VtuPiece
  particle_fields(const FlowView &view, const Layers &layers);
} // namespace Sandglass

#endif
