#ifndef sandglass_flow_particle_in_cell_settling_templates_h
#define sandglass_flow_particle_in_cell_settling_templates_h

#include <sandglass/flow/particle_in_cell/particle_stage.h>

#include <cmath>
#include <limits>

namespace Sandglass
{
  template <typename Layout>
  Settling
  ParticleStage<Layout>::settle()
  {
    // A hundred-thousandth of the speed after a free fall through the silo.
    constexpr double       slow       = 1e-5;
    constexpr unsigned int most_steps = 5000;
    // Loose particles at the surface never rest: they fall, and the stops would
    // lift them step by step.
    constexpr unsigned int most_idle_stops = 3;

    const double goal =
      slow * std::sqrt(2. * scene.gravity.norm() * fall_height(scene));
    const Clock       clock_before   = time;
    const StepControl control_before = control;
    Settling          result;
    is_settling                 = true;
    double       kinetic_energy = 0.;
    double       lowest_maximum = std::numeric_limits<double>::infinity();
    unsigned int n_idle_stops   = 0;
    while (result.n_steps < most_steps && n_idle_stops < most_idle_stops)
      {
        time.time = clock_before.time;
        this->step();
        ++result.n_steps;

        const FlowTotals totals = this->totals();
        result.largest_speed    = totals.largest_speed;
        // The second step tells whether the first has set anything in motion.
        if (result.n_steps > 1 && totals.largest_speed < goal)
          break;
        if (totals.kinetic_energy >= kinetic_energy)
          {
            kinetic_energy = totals.kinetic_energy;
            continue;
          }
        ++n_idle_stops;
        if (kinetic_energy < 0.5 * lowest_maximum)
          {
            lowest_maximum = kinetic_energy;
            n_idle_stops   = 0;
          }
        kinetic_energy = 0.;
        stop_particles();
      }
    stop_particles();

    is_settling = false;
    time        = clock_before;
    control     = control_before;
    removed     = RemovedMass();
    outlets.forget_removed();
    plastic_dissipation = 0.;
    particle_steps      = 0;
    contact.forget_records();
    return result;
  }



  template <typename Layout>
  void
  ParticleStage<Layout>::stop_particles()
  {
    edit_blocks([](Blocks &blocks) {
      blocks.for_each([&blocks](const ParticleSlot &slot) {
        blocks[slot.block].set_point(Block::velocity, slot.lane, Point<dim>());
      });
    });
  }
} // namespace Sandglass

#endif
