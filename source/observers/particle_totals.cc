#include <deal.II/base/mpi.h>

#include <sandglass/base/instruction_sets.h>
#include <sandglass/observers/particle_totals.h>
#include <sandglass/particles/particle_state.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    enum Sum : unsigned int
    {
      mass_in_silo,
      mass_falling,
      kinetic_energy,
      elastic_energy,
      momentum_x,
      momentum_y,
      n_particle_sums,
      mass_removed = n_particle_sums,
      mass_lost,
      dissipated_energy,
      n_sums
    };

    /// Sums over the particles of each lane.
    struct LaneSums
    {
      std::array<Lanes, n_particle_sums> sums;
      Lanes                              largest_squared_speed;

      LaneSums()
        : largest_squared_speed(0.)
      {
        sums.fill(Lanes(0.));
      }

      /// Lanes without a particle have no mass and the first one's speed.
      void
      add(const ParticleState<Lanes> &state, const Elasticity &elasticity)
      {
        const Lanes &mass   = state.mass;
        const Lanes &u      = state.velocity[0];
        const Lanes &v      = state.velocity[1];
        const Lanes  square = u * u + v * v;
        const auto   falls  = state.location[1] < Lanes(0.);

        sums[mass_in_silo] += select(falls, Lanes(0.), mass);
        sums[mass_falling] += select(falls, mass, Lanes(0.));
        sums[kinetic_energy] += Lanes(0.5) * mass * square;
        sums[elastic_energy] +=
          elasticity.energy_density(state.stress) * state.volume();
        sums[momentum_x] += mass * u;
        sums[momentum_y] += mass * v;
        largest_squared_speed =
          select(largest_squared_speed < square, square, largest_squared_speed);
      }
    };



    /// This rank's particles; in order of cells, which doesn't depend on
    /// history.
    LaneSums
    sums_of_particles(ParticleStage &stage, const Elasticity &elasticity)
    {
      LaneSums              sums;
      const ParticleBlocks &blocks = stage.cloud.blocks();
      run_with_widest_vectors([&]() {
        for (const unsigned int cell : blocks.cells())
          blocks.for_each_block_in_cell(cell, [&](const unsigned int block) {
            sums.add(load_state(blocks[block]), elasticity);
          });
      });
      return sums;
    }
  } // namespace



  ParticleTotals::ParticleTotals(ParticleStage    &stage,
                                 const Elasticity &elasticity)
  {
    const MPI_Comm communicator = stage.scene.communicator;

    const LaneSums             of_lanes = sums_of_particles(stage, elasticity);
    std::array<double, n_sums> sums;
    for (unsigned int i = 0; i < n_particle_sums; ++i)
      sums[i] = sum(of_lanes.sums[i]);
    sums[Sum::mass_removed] = stage.removed_mass().discharged;
    sums[Sum::mass_lost]    = stage.removed_mass().lost;
    sums[Sum::dissipated_energy] =
      stage.plastic_dissipation + stage.contact.friction_dissipation();
    const ArrayView<double> view(sums.data(), sums.size());
    Utilities::MPI::sum(ArrayView<const double>(view), communicator, view);

    const double factor = stage.scene.symmetry_factor;
    mass_in_silo        = factor * sums[Sum::mass_in_silo];
    mass_falling        = factor * sums[Sum::mass_falling];
    mass_removed        = factor * sums[Sum::mass_removed];
    mass_lost           = factor * sums[Sum::mass_lost];
    kinetic_energy      = factor * sums[Sum::kinetic_energy];
    elastic_energy      = factor * sums[Sum::elastic_energy];
    dissipated_energy   = factor * sums[Sum::dissipated_energy];
    momentum[0]         = sums[Sum::momentum_x];
    momentum[1]         = factor * sums[Sum::momentum_y];

    n_particles =
      Utilities::MPI::sum(static_cast<unsigned long>(
                            stage.cloud.n_locally_owned_particles()),
                          communicator);
    particle_steps = Utilities::MPI::sum(stage.particle_steps, communicator);
    double largest_square = 0.;
    for (unsigned int lane = 0; lane < Lanes::n; ++lane)
      largest_square =
        std::max(largest_square, of_lanes.largest_squared_speed[lane]);
    largest_speed =
      Utilities::MPI::max(std::sqrt(largest_square), communicator);
  }
} // namespace Sandglass
