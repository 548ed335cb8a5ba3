#include <deal.II/base/mpi.h>

#include <sandglass/output/silo_totals.h>
#include <sandglass/run/flow_state.h>
#include <sandglass/run/load_balance.h>
#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <numeric>

#include "imbalance.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// What makes a partition.
  struct Choice
  {
    CellType    cell_type;
    Partitioner partitioner;
  };

  /// A silo in flow whose stage can move to another partition.
  struct Silo : StageFixture
  {
    explicit Silo(const Choice &choice = {CellType::triangle,
                                          Partitioner::metis})
      : partitioner(choice.partitioner)
    {
      SceneParameters silo;
      silo.cell_type         = choice.cell_type;
      silo.half_width        = 0.3;
      silo.wall_height       = 0.6;
      silo.outlet_half_width = 0.1;
      silo.fall_region_depth = 0.3;
      silo.element_size      = 0.05;
      mesh                   = make_mesh<2>(silo, MPI_COMM_WORLD);
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
      auto next_scene = std::make_unique<Scene<2>>(mesh,
                                                   walls,
                                                   formulation,
                                                   particles_per_cell,
                                                   gravity,
                                                   MPI_COMM_WORLD,
                                                   partitioner,
                                                   cell_weights);
      auto next_flow  = make_flow(*next_scene);
      hand_over(*stage, *next_flow, MPI_COMM_WORLD);
      steps_before += stage->view().totals().particle_steps;
      stage.reset(dynamic_cast<Stage *>(next_flow.release()));
      scene = std::move(next_scene);
    }

    SiloTotals
    totals() const
    {
      SiloTotals result(stage->view().totals(), scene->symmetry_factor);
      result.particle_steps += steps_before;
      return result;
    }

    /// What the automatic time step remembers.
    StepControl
    control() const
    {
      std::istringstream              stream(saved_state(*stage));
      boost::archive::binary_iarchive archive(stream);
      Clock                           clock;
      StepControl                     control;
      archive >> clock >> control;
      return control;
    }

    /// Sum of the mean normal forces since the start, in N.
    double
    wall_force() const
    {
      const WallRecords records = stage->view().wall_records();
      double            sum     = 0.;
      for (const auto &record : records.records)
        sum -= record.impulse * record.normal / records.time;
      return Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    }

    const Partitioner partitioner;
    Mesh<2>           mesh;
    unsigned long     steps_before = 0; ///< of stages on other partitions
  };

  class HandOver : public testing::TestWithParam<Choice>
  {};

  /// Weights almost all on the cells of the outlet's height and below.
  std::vector<unsigned int>
  weights_below(const Silo &silo)
  {
    std::vector<unsigned int> weights;
    for (const auto &cell : silo.scene->triangulation.active_cell_iterators())
      weights.push_back(cell->center()[1] < 0.1 ? 100 : 1);
    return weights;
  }
} // namespace



TEST_P(HandOver, GoesOnAsWithoutIt)
{
  Silo       moved(GetParam()), stayed(GetParam());
  const auto owners = moved.scene->cell_owners;
  moved.move_to(weights_below(moved));
  EXPECT_EQ(moved.scene->cell_owners == owners,
            Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1);
  EXPECT_EQ(moved.control().automatic_time_step,
            stayed.control().automatic_time_step);
  EXPECT_EQ(moved.control().last_critical_time_step,
            stayed.control().last_critical_time_step);
  for (Silo *silo : {&moved, &stayed})
    silo->run(100);

  const SiloTotals a = moved.totals(), b = stayed.totals();
  EXPECT_EQ(a.n_particles, b.n_particles);
  EXPECT_EQ(a.particle_steps, b.particle_steps);
  EXPECT_NEAR(a.mass() / b.mass(), 1., 1e-12);
  EXPECT_NEAR(a.mass_discharged() / b.mass_discharged(), 1., 1e-9);
  EXPECT_NEAR(a.kinetic_energy / b.kinetic_energy, 1., 1e-9);
  EXPECT_NEAR(a.elastic_energy / b.elastic_energy, 1., 1e-9);
  EXPECT_NEAR(a.dissipated_energy / b.dissipated_energy, 1., 1e-9);
  EXPECT_NEAR(moved.stage->view().clock().time /
                stayed.stage->view().clock().time,
              1.,
              1e-12);
  EXPECT_NEAR(moved.wall_force() / stayed.wall_force(), 1., 1e-9);
}



// Particles only below y = 0.3 m: by the weights of the filled cells one rank
// would have most of them.
TEST_P(HandOver, SharesWorkOutEvenly)
{
  Silo silo(GetParam());
  silo.stage->edit_particles([](auto &handler) {
    std::vector<typename std::decay_t<decltype(handler)>::particle_iterator>
      above;
    for (auto particle = handler.begin(); particle != handler.end(); ++particle)
      if (particle->get_location()[1] > 0.3)
        above.push_back(particle);
    handler.remove_particles(above);
  });

  const auto   weights = cell_weights(*silo.stage, MPI_COMM_WORLD);
  const double before  = imbalance(*silo.scene, weights);
  silo.move_to(weights);
  EXPECT_LT(imbalance(*silo.scene, weights), 1.1);
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    {
      EXPECT_GT(before, 1.3);
    }
}



INSTANTIATE_TEST_SUITE_P(
  Choices,
  HandOver,
  testing::Values(Choice{CellType::triangle, Partitioner::metis},
                  Choice{CellType::quadrilateral, Partitioner::metis},
                  Choice{CellType::quadrilateral, Partitioner::p4est}));



// Weights count 20 for a particle, and 7 times that for each that leaves its
// cell in a step.
TEST(LoadBalance, WeightsKnowHowManyParticlesLeaveTheirCells)
{
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    GTEST_SKIP() << "particles are followed on one rank";
  Silo  silo;
  auto &stage = *silo.stage;

  const auto cells_of_particles = [&]() {
    std::map<types::particle_index, unsigned int> cells;
    stage.particles().blocks().for_each([&](const ParticleSlot &slot) {
      cells[stage.particles().blocks().id(slot)] = slot.cell;
    });
    return cells;
  };
  const auto sum_of = [](const std::vector<unsigned int> &weights) {
    return std::accumulate(weights.begin(), weights.end(), 0.);
  };
  const auto sum_at_rest = [&]() {
    std::vector<double> work;
    for (const CellRecord &cell : stage.view().grid().cells)
      work.push_back(cell_work(cell.n_particles));
    return sum_of(cell_weights(work));
  };

  double       n_leaving = 0.;
  unsigned int n_left    = 0;
  for (unsigned int step = 0; step < 50; ++step)
    {
      const double weight_of_leaving =
        sum_of(cell_weights(stage, MPI_COMM_WORLD)) - sum_at_rest();
      n_leaving += weight_of_leaving / (7. * 20.);

      const auto before = cells_of_particles();
      stage.step();
      const auto after = cells_of_particles();
      for (const auto &[id, cell] : before)
        n_left += after.count(id) == 0 || after.at(id) != cell;
    }
  std::cout << n_left << " have left, expected: " << n_leaving << std::endl;
  EXPECT_GT(n_left, 100u);
  EXPECT_NEAR(n_leaving / n_left, 1., 0.1);
}
