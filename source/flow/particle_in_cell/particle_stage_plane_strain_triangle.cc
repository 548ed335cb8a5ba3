#include <sandglass/flow/particle_in_cell/make_particle_stage.templates.h>

namespace Sandglass
{
  template std::unique_ptr<DynamicFlow<PlaneStrain::dim>>
  make_particle_stage<PlaneStrain, CellType::triangle>(
    const Scene<PlaneStrain::dim> &,
    const MaterialParameters &,
    const WallParameters &,
    const ParticleStageParameters &);
} // namespace Sandglass
