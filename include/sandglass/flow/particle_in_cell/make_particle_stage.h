#ifndef sandglass_flow_particle_in_cell_make_particle_stage_h
#define sandglass_flow_particle_in_cell_make_particle_stage_h

#include <sandglass/flow/make_flow.h>

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
                      const ParticleStageParameters &parameters);
} // namespace Sandglass

#endif
