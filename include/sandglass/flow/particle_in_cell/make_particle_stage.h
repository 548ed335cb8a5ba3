#ifndef sandglass_flow_particle_in_cell_make_particle_stage_h
#define sandglass_flow_particle_in_cell_make_particle_stage_h

#include <sandglass/flow/dynamic_flow.h>
#include <sandglass/flow/particle_in_cell/feed_parameters.h>
#include <sandglass/flow/particle_in_cell/particle_stage_parameters.h>
#include <sandglass/material/material_parameters.h>
#include <sandglass/scene/scene.h>
#include <sandglass/walls/wall_parameters.h>

#include <memory>

namespace Sandglass
{
  /**
   * The particle stage of one kinematics and cell type, with the law that the
   * parameters name. Defined in make_particle_stage.templates.h and
   * instantiated by cmake/choices.cmake.
   */
  template <typename Kinematics, CellType cell_type>
  std::unique_ptr<DynamicFlow<Kinematics::dim>>
  make_particle_stage(const Scene<Kinematics::dim>  &scene,
                      const MaterialParameters      &material,
                      const WallParameters          &walls,
                      const ParticleStageParameters &parameters,
                      const FeedParameters          &feed);
} // namespace Sandglass

#endif
