#include <deal.II/base/mpi.h>

#include <sandglass/material/material_parameters.h>
#include <sandglass/observers/checkpoint.h>
#include <sandglass/observers/particle_totals.h>
#include <sandglass/run/load_balance.h>
#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// A silo in flow whose stage can move to another partition.
  struct Silo : StageFixture
  {
    Silo()
    {
      SceneParameters silo;
      silo.half_width        = 0.3;
      silo.wall_height       = 0.6;
      silo.outlet_half_width = 0.1;
      silo.fall_region_depth = 0.3;
      silo.element_size      = 0.05;
      mesh                   = make_mesh(silo, MPI_COMM_WORLD);
      start(mesh);
      run(100);
    }

    void
    run(const unsigned int n_steps)
    {
      for (unsigned int n = 0; n < n_steps; ++n)
        stage->step();
    }

    void
    move_to(const std::vector<unsigned int> &cell_weights)
    {
      auto next_scene = std::make_unique<Scene>(mesh,
                                                formulation,
                                                particles_per_cell,
                                                gravity,
                                                MPI_COMM_WORLD,
                                                cell_weights);
      auto next_stage =
        make_particle_stage(*next_scene, material, walls, parameters);
      hand_over(*stage, *next_stage);
      stage = std::move(next_stage);
      scene = std::move(next_scene);
    }

    ParticleTotals
    totals() const
    {
      return {*stage, material.elasticity()};
    }

    Mesh mesh;
  };

  /// All on the cells of the outlet's height and below.
  std::vector<unsigned int>
  weights_below(const Silo &silo)
  {
    std::vector<unsigned int> weights;
    for (const auto &cell : silo.scene->triangulation.active_cell_iterators())
      weights.push_back(cell->center()[1] < 0.1 ? 100 : 1);
    return weights;
  }
} // namespace



TEST(HandOver, GoesOnAsWithoutIt)
{
  Silo moved, stayed;
  moved.move_to(weights_below(moved));
  for (Silo *silo : {&moved, &stayed})
    silo->run(100);

  const ParticleTotals a = moved.totals(), b = stayed.totals();
  EXPECT_EQ(a.n_particles, b.n_particles);
  EXPECT_EQ(a.particle_steps, b.particle_steps);
  EXPECT_NEAR(a.mass() / b.mass(), 1., 1e-12);
  EXPECT_NEAR(a.mass_discharged() / b.mass_discharged(), 1., 1e-9);
  EXPECT_NEAR(a.kinetic_energy / b.kinetic_energy, 1., 1e-9);
  EXPECT_NEAR(a.elastic_energy / b.elastic_energy, 1., 1e-9);
  EXPECT_NEAR(a.dissipated_energy / b.dissipated_energy, 1., 1e-9);
  EXPECT_NEAR(moved.stage->clock.time / stayed.stage->clock.time, 1., 1e-12);
}



// Particles only below y = 0.3 m: by the weights of the filled cells one rank
// would have most of them.
TEST(HandOver, SharesParticlesOutEvenly)
{
  Silo silo;
  silo.stage->cloud.edit([](auto &handler) {
    std::vector<typename std::decay_t<decltype(handler)>::particle_iterator>
      above;
    for (auto particle = handler.begin(); particle != handler.end(); ++particle)
      if (particle->get_location()[1] > 0.3)
        above.push_back(particle);
    handler.remove_particles(above);
  });

  const auto imbalance = [&]() {
    const auto n =
      Utilities::MPI::min_max_avg(silo.stage->cloud.n_locally_owned_particles(),
                                  MPI_COMM_WORLD);
    return n.max / n.avg;
  };
  const double before = imbalance();
  silo.move_to(LoadBalance::cell_weights(*silo.stage));
  EXPECT_LT(imbalance(), 1.1);
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    {
      EXPECT_GT(before, 1.3);
    }
}



// The other ranks' waiting is added up until it is as long as moving takes.
TEST(LoadBalance, IsLostWhenRanksHaveWaitedForLong)
{
  Silo        silo;
  LoadBalance balance(*silo.scene);
  const bool  is_alone = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
  bool        is_lost  = false;
  // All particles but one rank's are gone.
  const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  if (rank > 0)
    silo.stage->cloud.clear();
  for (unsigned int n = 0; n < 400000 && !is_lost; n += 100)
    {
      silo.stage->clock.step += 100;
      is_lost = balance.is_lost(*silo.stage);
      EXPECT_FALSE(is_lost && n < 300);
    }
  EXPECT_EQ(is_lost, !is_alone);
}
