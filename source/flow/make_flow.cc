#include <sandglass/choices/choose_kinematics.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/make_flow.h>
#include <sandglass/flow/particle_in_cell/make_particle_stage.h>
#include <sandglass/flow/updated_lagrangian/motion/updated_lagrangian_flow.h>

namespace Sandglass
{
  template <int dim>
  std::unique_ptr<DynamicFlow<dim>>
  make_flow(const Scene<dim>         &scene,
            const MaterialParameters &material,
            const WallParameters     &walls,
            const FlowChoice         &choice,
            ConditionalOStream       &log)
  {
    if constexpr (dim == 2)
      if (choice.flow.method == FlowParameters::Method::updated_lagrangian)
        return std::make_unique<UpdatedLagrangianFlow>(
          scene,
          material,
          walls,
          choice.updated_lagrangian,
          choice.static_stage,
          choice.particle_stage.end_time,
          log);
    std::unique_ptr<DynamicFlow<dim>> flow;
    choose_kinematics<dim>(scene.formulation, [&](const auto kinematics) {
      choose_cell_type<dim>(scene.mesh.cell_type, [&](const auto cells) {
        flow = make_particle_stage<typename decltype(kinematics)::Type,
                                   decltype(cells)::Type::value>(
          scene, material, walls, choice.particle_stage, choice.feed);
      });
    });
    return flow;
  }



#define INSTANTIATE(dim)                                     \
  template std::unique_ptr<DynamicFlow<dim>> make_flow<dim>( \
    const Scene<dim> &,                                      \
    const MaterialParameters &,                              \
    const WallParameters &,                                  \
    const FlowChoice &,                                      \
    ConditionalOStream &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
