#ifndef sandglass_particle_stage_make_explicit_particle_stage_templates_h
#define sandglass_particle_stage_make_explicit_particle_stage_templates_h

#include <sandglass/particle_stage/explicit_particle_stage.h>
#include <sandglass/particle_stage/make_explicit_particle_stage.h>

namespace Sandglass
{
  template <typename Setting>
  std::unique_ptr<ParticleStage>
  make_explicit_particle_stage(const Scene                   &scene,
                               const MaterialParameters      &material,
                               const WallParameters          &walls,
                               const ParticleStageParameters &parameters)
  {
    switch (parameters.density_update)
      {
        case DensityUpdate::paper:
          return std::make_unique<
            ExplicitParticleStage<Setting, DensityUpdate::paper>>(scene,
                                                                  material,
                                                                  walls,
                                                                  parameters);
        case DensityUpdate::constant:
          return std::make_unique<
            ExplicitParticleStage<Setting, DensityUpdate::constant>>(
            scene, material, walls, parameters);
        case DensityUpdate::floor:
          return std::make_unique<
            ExplicitParticleStage<Setting, DensityUpdate::floor>>(scene,
                                                                  material,
                                                                  walls,
                                                                  parameters);
        case DensityUpdate::separation:
          return std::make_unique<
            ExplicitParticleStage<Setting, DensityUpdate::separation>>(
            scene, material, walls, parameters);
      }
    Assert(false, ExcInternalError());
    return nullptr;
  }
} // namespace Sandglass

#endif
