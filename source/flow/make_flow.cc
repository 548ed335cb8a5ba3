#include <sandglass/choices.h>
#include <sandglass/flow/make_flow.h>
#include <sandglass/flow/particle_in_cell/make_particle_stage.h>

namespace Sandglass
{
  template <int dim>
  std::unique_ptr<DynamicFlow<dim>>
  make_flow(const Scene<dim>              &scene,
            const MaterialParameters      &material,
            const WallParameters          &walls,
            const ParticleStageParameters &parameters)
  {
    std::unique_ptr<DynamicFlow<dim>> flow;
    choose_kinematics<dim>(scene.formulation, [&](const auto kinematics) {
      choose_cell_type<dim>(scene.mesh.cell_type, [&](const auto cells) {
        flow = make_particle_stage<typename decltype(kinematics)::Type,
                                   decltype(cells)::Type::value>(scene,
                                                                 material,
                                                                 walls,
                                                                 parameters);
      });
    });
    return flow;
  }



#define INSTANTIATE(dim)                                     \
  template std::unique_ptr<DynamicFlow<dim>> make_flow<dim>( \
    const Scene<dim> &,                                      \
    const MaterialParameters &,                              \
    const WallParameters &,                                  \
    const ParticleStageParameters &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
