#ifndef sandglass_flow_make_flow_h
#define sandglass_flow_make_flow_h

#include <deal.II/base/conditional_ostream.h>

#include <sandglass/flow/dynamic_flow.h>
#include <sandglass/flow/flow_parameters.h>
#include <sandglass/flow/particle_in_cell/feed_parameters.h>
#include <sandglass/flow/particle_in_cell/particle_stage_parameters.h>
#include <sandglass/flow/updated_lagrangian/static_stage_parameters.h>
#include <sandglass/flow/updated_lagrangian/updated_lagrangian_parameters.h>
#include <sandglass/material/material_parameters.h>
#include <sandglass/scene/scene.h>
#include <sandglass/walls/wall_parameters.h>

#include <memory>

namespace Sandglass
{
  /// What a flow is to be like.
  struct FlowChoice
  {
    const FlowParameters              &flow;
    const ParticleStageParameters     &particle_stage;
    const UpdatedLagrangianParameters &updated_lagrangian;
    const StaticStageParameters       &static_stage;
    const FeedParameters              &feed;
  };

  /// The flow that the parameters ask for, its material seeded, unstressed and
  /// at rest. The arguments and what they refer to have to live as long as it
  /// does, but not the choice. Throws InputError.
  template <int dim>
  std::unique_ptr<DynamicFlow<dim>>
  make_flow(const Scene<dim>         &scene,
            const MaterialParameters &material,
            const WallParameters     &walls,
            const FlowChoice         &choice,
            ConditionalOStream       &log);
} // namespace Sandglass

#endif
