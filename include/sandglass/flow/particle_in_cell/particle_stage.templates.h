#ifndef sandglass_flow_particle_in_cell_particle_stage_templates_h
#define sandglass_flow_particle_in_cell_particle_stage_templates_h

#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/flow/particle_in_cell/particle_stage.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  /// Height from the material's top to the grid's bottom, in m.
  template <int dim>
  double
  fall_height(const Scene<dim> &scene)
  {
    double bottom = scene.fill_bottom;
    for (const auto &vertex : scene.mesh.vertices)
      bottom = std::min(bottom, vertex[1]);
    return scene.fill_top - bottom;
  }



  template <typename Layout>
  ParticleStage<Layout>::ParticleStage(
    const Scene                   &scene,
    const WallParameters          &walls,
    const ParticleStageParameters &parameters)
    : scene(scene)
    , parameters(parameters)
    , cloud(scene)
    , fields(*scene.nodes)
    , contact(scene, walls)
    , outlets(scene.mesh)
    , speed_limit(parameters.largest_speed *
                  std::sqrt(2. * scene.gravity.norm() * fall_height(scene)))
  {}



  template <typename Layout>
  double
  ParticleStage<Layout>::largest_speed() const
  {
    double largest = 0.;
    cloud.blocks().for_each([&](const ParticleSlot &slot) {
      const Point<dim> velocity =
        cloud.blocks()[slot.block].point(Block::velocity, slot.lane);
      largest = std::max(largest, velocity.square());
    });
    return std::sqrt(largest);
  }



  template <typename Layout>
  void
  ParticleStage<Layout>::check_speed() const
  {
    constexpr unsigned long interval = 100;
    if (time.step % interval != 0 || speed_limit == 0.)
      return;
    const double speed =
      Utilities::MPI::max(largest_speed(), scene.communicator);
    if (speed > speed_limit)
      throw RunError(describe(time) + "the fastest particle moves at " +
                     std::to_string(speed) + " m/s, more than " +
                     std::to_string(parameters.largest_speed) +
                     " times the free fall through the grid; the run is "
                     "unstable. Try a smaller Particle stage/Time step (auto "
                     "follows the critical one) or another Density update.");
  }



  template <typename Layout>
  double
  ParticleStage<Layout>::critical_time_step(const bool is_exact) const
  {
    return !is_exact && control.last_critical_time_step > 0. ?
             control.last_critical_time_step :
             find_critical_time_step();
  }



  template <typename Layout>
  void
  ParticleStage<Layout>::start_from(
    const InitialStateFunction<dim>   &initial_state,
    const std::vector<WallForce<dim>> &wall_forces)
  {
    Blocks &blocks = cloud.change_blocks();
    blocks.for_each([&](const ParticleSlot &slot) {
      Parcel particle = blocks.parcel(slot);
      set_initial_state(initial_state, particle);
      blocks.overwrite(slot, particle);
    });
    relocate_strays();
    sum_over_particles();
    contact.start_from(wall_forces);
  }



  template <typename Layout>
  double
  ParticleStage<Layout>::choose_time_step()
  {
    double step = 0.;
    if (parameters.has_automatic_time_step)
      {
        if (time.step % parameters.automatic_step_interval() == 0 ||
            control.automatic_time_step == 0.)
          {
            // A stiff spot that has come once comes again: after it the step
            // recovers slowly, by 2.5 % in a hundred steps.
            constexpr double growth_of_step = 1.00025;
            const double     growth =
              std::pow(growth_of_step, parameters.automatic_step_interval());
            const double last               = control.automatic_time_step;
            control.last_critical_time_step = find_critical_time_step();
            control.automatic_time_step =
              parameters.time_step_safety *
              std::min(control.last_critical_time_step,
                       control.seeded_critical_time_step);
            if (last > 0.)
              control.automatic_time_step =
                std::min(control.automatic_time_step, growth * last);
            control.last_local_eigenvalue = local_eigenvalue();
          }
        const double known = std::max(control.last_local_eigenvalue,
                                      control.seeded_local_eigenvalue);
        step               = control.automatic_time_step *
               std::sqrt(std::min(1., known / local_eigenvalue()));
      }
    else
      // Rounding of the summed time must not put off the table's next line.
      for (const auto &[start, table_step] : parameters.time_steps)
        if (time.time >= start * (1. - 1e-12))
          step = table_step;

    const double remaining = parameters.end_time - time.time;
    return step > remaining * (1. - 1e-9) ? remaining : step;
  }
} // namespace Sandglass

#endif
