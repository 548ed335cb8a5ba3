#include <sandglass/particle_stage/make_explicit_particle_stage.templates.h>

namespace Sandglass
{
  template std::unique_ptr<ParticleStage>
  make_explicit_particle_stage<
    Setting<Formulation::plane_strain, CellType::triangle>>(
    const Scene &,
    const MaterialParameters &,
    const WallParameters &,
    const ParticleStageParameters &);
} // namespace Sandglass
