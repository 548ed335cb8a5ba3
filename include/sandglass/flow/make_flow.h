#ifndef sandglass_flow_make_flow_h
#define sandglass_flow_make_flow_h

#include <sandglass/flow/dynamic_flow.h>
#include <sandglass/flow/particle_in_cell/particle_stage_parameters.h>
#include <sandglass/material/material_parameters.h>
#include <sandglass/scene/scene.h>
#include <sandglass/walls/wall_parameters.h>

#include <memory>

namespace Sandglass
{
  /// The flow that the parameters ask for, its material seeded, unstressed and
  /// at rest. The arguments have to live as long as it does.
  template <int dim>
  std::unique_ptr<DynamicFlow<dim>>
  make_flow(const Scene<dim>              &scene,
            const MaterialParameters      &material,
            const WallParameters          &walls,
            const ParticleStageParameters &parameters);
} // namespace Sandglass

#endif
