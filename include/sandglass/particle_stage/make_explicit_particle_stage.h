#ifndef sandglass_particle_stage_make_explicit_particle_stage_h
#define sandglass_particle_stage_make_explicit_particle_stage_h

#include <sandglass/particle_stage/particle_stage.h>

namespace Sandglass
{
  /**
   * The particle stage for one Setting. Defined in
   * make_explicit_particle_stage.templates.h and instantiated in one source
   * file for each Setting, so that these compile at the same time.
   */
  template <typename Setting>
  std::unique_ptr<ParticleStage>
  make_explicit_particle_stage(const Scene                   &scene,
                               const MaterialParameters      &material,
                               const WallParameters          &walls,
                               const ParticleStageParameters &parameters);
} // namespace Sandglass

#endif
