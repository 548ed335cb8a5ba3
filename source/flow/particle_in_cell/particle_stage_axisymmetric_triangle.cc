#include <sandglass/flow/particle_in_cell/make_particle_stage.templates.h>

namespace Sandglass
{
  template std::unique_ptr<DynamicFlow<Axisymmetric::dim>>
  make_particle_stage<Axisymmetric, CellType::triangle>(
    const Scene<Axisymmetric::dim> &,
    const MaterialParameters &,
    const WallParameters &,
    const ParticleStageParameters &);
} // namespace Sandglass
