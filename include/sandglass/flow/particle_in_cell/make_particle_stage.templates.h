#ifndef sandglass_flow_particle_in_cell_make_particle_stage_templates_h
#define sandglass_flow_particle_in_cell_make_particle_stage_templates_h

#include <sandglass/choices/choose_law.h>
#include <sandglass/flow/particle_in_cell/explicit_particle_stage.h>
#include <sandglass/flow/particle_in_cell/make_particle_stage.h>

namespace Sandglass
{
  template <typename Kinematics, CellType cell_type>
  std::unique_ptr<DynamicFlow<Kinematics::dim>>
  make_particle_stage(const Scene<Kinematics::dim>  &scene,
                      const MaterialParameters      &material,
                      const WallParameters          &walls,
                      const ParticleStageParameters &parameters,
                      const FeedParameters          &feed)
  {
    std::unique_ptr<DynamicFlow<Kinematics::dim>> stage;
    choose_law_in<Kinematics::dim>(material, [&](const auto law) {
      using Law = typename decltype(law)::Type;
      using Setting =
        Sandglass::Setting<Kinematics, cell_type, n_state_numbers<Law>()>;
      const auto make = [&](const CellGeometry<cell_type> &geometry) {
        return make_law<Setting, Law>(material, parameters, geometry);
      };
      stage = std::make_unique<ExplicitParticleStage<Setting>>(
        scene, make, material.density, walls, parameters, feed);
    });
    return stage;
  }
} // namespace Sandglass

#endif
