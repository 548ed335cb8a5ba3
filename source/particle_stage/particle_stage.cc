#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/particle_stage/make_explicit_particle_stage.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    /// Height from the material's top to the grid's bottom, in m.
    double
    fall_height(const Scene &scene)
    {
      double bottom = scene.fill_bottom;
      for (const auto &vertex : scene.mesh.vertices)
        bottom = std::min(bottom, vertex[1]);
      return scene.fill_top - bottom;
    }
  } // namespace



  ParticleStage::ParticleStage(const Scene                   &scene,
                               const WallParameters          &walls,
                               const ParticleStageParameters &parameters)
    : scene(scene)
    , parameters(parameters)
    , cloud(scene)
    , fields(*scene.nodes)
    , contact(scene, walls)
    , speed_limit(parameters.largest_speed *
                  std::sqrt(2. * scene.gravity.norm() * fall_height(scene)))
  {}



  double
  ParticleStage::largest_speed() const
  {
    double largest = 0.;
    cloud.blocks().for_each([&](const ParticleSlot &slot) {
      const Point<dim> velocity =
        cloud.blocks()[slot.block].point(ParticleBlock::velocity, slot.lane);
      largest = std::max(largest, velocity.square());
    });
    return std::sqrt(largest);
  }



  void
  ParticleStage::check_speed() const
  {
    constexpr unsigned long interval = 100;
    if (clock.step % interval != 0 || speed_limit == 0.)
      return;
    const double speed =
      Utilities::MPI::max(largest_speed(), scene.communicator);
    if (speed > speed_limit)
      throw RunError(describe(clock) + "the fastest particle moves at " +
                     std::to_string(speed) + " m/s, more than " +
                     std::to_string(parameters.largest_speed) +
                     " times the free fall through the grid; the run is "
                     "unstable. Try a smaller Particle stage/Time step (auto "
                     "follows the critical one) or another Density update.");
  }



  double
  ParticleStage::recent_critical_time_step()
  {
    return last_critical_time_step > 0. ? last_critical_time_step :
                                          critical_time_step();
  }



  double
  ParticleStage::choose_time_step()
  {
    double step = 0.;
    if (parameters.has_automatic_time_step)
      {
        if (clock.step % parameters.automatic_step_interval() == 0 ||
            automatic_time_step == 0.)
          {
            // A stiff spot that has come once comes again: after it the step
            // recovers slowly.
            constexpr double growth = 1.005;
            const double     last   = automatic_time_step;
            last_critical_time_step = find_critical_time_step();
            automatic_time_step =
              parameters.time_step_safety *
              std::min(last_critical_time_step, seeded_critical_time_step);
            if (last > 0.)
              automatic_time_step =
                std::min(automatic_time_step, growth * last);
            last_local_eigenvalue = local_eigenvalue();
          }
        const double known =
          std::max(last_local_eigenvalue, seeded_local_eigenvalue);
        step = automatic_time_step *
               std::sqrt(std::min(1., known / local_eigenvalue()));
      }
    else
      // Rounding of the summed time must not put off the table's next line.
      for (const auto &[start, table_step] : parameters.time_steps)
        if (clock.time >= start * (1. - 1e-12))
          step = table_step;

    const double remaining = parameters.end_time - clock.time;
    return step > remaining * (1. - 1e-9) ? remaining : step;
  }



  std::unique_ptr<ParticleStage>
  make_particle_stage(const Scene                   &scene,
                      const MaterialParameters      &material,
                      const WallParameters          &walls,
                      const ParticleStageParameters &parameters)
  {
    const auto make = [&](auto setting) {
      return make_explicit_particle_stage<decltype(setting)>(scene,
                                                             material,
                                                             walls,
                                                             parameters);
    };
    const bool is_plane = scene.formulation == Formulation::plane_strain;
    if (scene.mesh.cell_type == CellType::triangle)
      return is_plane ?
               make(Setting<Formulation::plane_strain, CellType::triangle>()) :
               make(Setting<Formulation::axisymmetric, CellType::triangle>());
    return is_plane ?
             make(
               Setting<Formulation::plane_strain, CellType::quadrilateral>()) :
             make(
               Setting<Formulation::axisymmetric, CellType::quadrilateral>());
  }
} // namespace Sandglass
