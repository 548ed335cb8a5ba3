// The particle stage on the flat-bottomed silo in flow: beside a plain loop, on
// finer meshes beside mesh 3, and the machine's limits.
//
// A machine that does other work as well makes times unreliable, so each is
// measured in pairs, and the counters are the medians of the pairs: of the
// ratio, and of the time itself. Processor time, not wall time. The parts of a
// step are measured by themselves, with the defaults.

#include <deal.II/base/mpi.h>

#include <sandglass/continuum/axisymmetric.h>
#include <sandglass/continuum/plane_strain.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>

#include "counted_parts.h"
#include "loop_difference.h"
#include "machine_limits.h"
#include "part_sums.h"

namespace
{
  using namespace Sandglass;

  /// Processor time in ns.
  double
  processor_time()
  {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e9 * time.tv_sec + time.tv_nsec;
  }



  /// Processor time of `function()`, in ns.
  template <typename Function>
  double
  measure(const Function &function)
  {
    const double start = processor_time();
    function();
    return processor_time() - start;
  }



  double
  median(std::vector<double> values)
  {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  }



  /// Long enough to measure.
  constexpr unsigned int particle_steps = 1000000;

  template <typename Setting>
  unsigned int
  steps_to_measure(const FlowingSilo<Setting> &silo)
  {
    return std::max(4u, particle_steps / silo.n_particles());
  }



  /// ns per particle and step.
  template <typename Setting>
  double
  measure(FlowingSilo<Setting> &silo, const unsigned int n_steps)
  {
    const unsigned long before = silo.stage->view().totals().particle_steps;
    const double        time   = measure([&]() { silo.run(n_steps); });
    return time / (silo.stage->view().totals().particle_steps - before);
  }



  /// What a step moves between processor and memory where no cache holds it,
  /// per particle in bytes.
  struct BytesMoved
  {
    double particles;     ///< the pass: blocks there and back, cells' sums
    double loop_of_cells; ///< shapes, nodes and sums
    double filled_lanes;

    double
    total() const
    {
      return particles + 2 * loop_of_cells;
    }
  };

  template <typename Setting>
  BytesMoved
  bytes_moved(const FlowingSilo<Setting> &silo)
  {
    const auto  &blocks  = silo.stage->particles().blocks();
    unsigned int n_cells = 0, n_blocks = 0;
    for_each_filled_cell(blocks, [&](const unsigned int cell) {
      ++n_cells;
      blocks.for_each_block_in_cell(cell, [&](unsigned int) { ++n_blocks; });
    });

    using Shape       = typename FlowingSilo<Setting>::Geometry::Shape;
    const double cell = sizeof(Shape) + 2 * Shape::n_nodes * sizeof(int);
    const double sums = sizeof(CellSums<Setting, double>);
    const double n    = silo.n_particles();
    return {(n_blocks * 2. * sizeof(ParticleBlock<StageLayout>) +
             n_cells * (cell + 2 * sums)) /
              n,
            n_cells * (cell + sums) / n,
            n / (Lanes::n * n_blocks)};
  }



  template <typename Setting>
  void
  report(benchmark::State           &state,
         const FlowingSilo<Setting> &silo,
         const std::vector<double>  &times)
  {
    const BytesMoved bytes                      = bytes_moved(silo);
    state.counters["particles"]                 = silo.n_particles();
    state.counters["ns_per_particle_step"]      = median(times);
    state.counters["particle_steps_per_second"] = 1e9 / median(times);
    state.counters["bytes_per_particle_step"]   = bytes.total();
    state.counters["filled_lanes"]              = bytes.filled_lanes;
  }



  template <typename Setting>
  void
  beside_plain_loop(benchmark::State &state)
  {
    FlowingSilo<Setting> silo(1);
    PlainLoop<Setting>   plain(*silo.scene,
                             silo.material,
                             silo.walls,
                             silo.stage->particles().handler());
    const auto           run_plain = [&](const unsigned int n_steps) {
      for (unsigned int n = 0; n < n_steps; ++n)
        plain.step(silo.parameters.time_steps[0].second);
    };
    // Compare before the flow lets rounding grow.
    constexpr unsigned int n_steps_to_compare = 200, n_steps_to_flow = 1000;
    silo.run(n_steps_to_compare);
    run_plain(n_steps_to_compare);
    state.counters["difference"] = loop_difference(silo, plain);
    if (!(state.counters["difference"] < 1e-9))
      state.SkipWithError("the two loops' results differ");
    silo.run(n_steps_to_flow);
    run_plain(n_steps_to_flow);

    const unsigned int  n_steps = steps_to_measure(silo);
    std::vector<double> times, ratios;
    for (auto _ : state)
      {
        const unsigned long before = silo.stage->view().totals().particle_steps;
        times.push_back(measure(silo, n_steps));
        const double n_particle_steps =
          silo.stage->view().totals().particle_steps - before;
        const double plain_time = measure([&]() { run_plain(n_steps); });
        ratios.push_back(plain_time / n_particle_steps / times.back());
        state.SetIterationTime(1e-9 * times.back());
      }
    report(state, silo, times);
    state.counters["plain_over_stage"] = median(ratios);
  }



  /// Measure a silo in pairs with another, and report it; `counter` is its time
  /// over the other's.
  template <typename Setting>
  void
  measure_beside(benchmark::State     &state,
                 FlowingSilo<Setting> &silo,
                 FlowingSilo<Setting> &other,
                 const std::string    &counter)
  {
    std::vector<double> times, ratios;
    for (auto _ : state)
      {
        times.push_back(measure(silo, steps_to_measure(silo)));
        ratios.push_back(times.back() /
                         measure(other, steps_to_measure(other)));
        state.SetIterationTime(1e-9 * times.back());
      }
    report(state, silo, times);
    state.counters[counter] = median(ratios);
  }



  /// What the averaged strain and the force on cells, the defaults, cost.
  template <typename Setting>
  void
  defaults_beside_paper(benchmark::State &state)
  {
    using Silo = FlowingSilo<Setting>;
    Silo paper(1), silo(1, Silo::Method::program);
    paper.run(1200);
    silo.run(1200);

    measure_beside(state, silo, paper, "time_over_paper");
  }



  template <typename Setting>
  void
  beside_mesh_3(benchmark::State &state)
  {
    FlowingSilo<Setting> mesh_3(1), silo(state.range(0));
    mesh_3.run(1200);
    silo.take_velocity(mesh_3);
    silo.run(20);

    measure_beside(state, silo, mesh_3, "time_over_mesh_3");
  }



  /// The silo in flow with the defaults, on the mesh that the range says.
  template <typename Setting>
  std::unique_ptr<FlowingSilo<Setting>>
  make_flowing_silo(const unsigned int refinement)
  {
    using Silo  = FlowingSilo<Setting>;
    auto mesh_3 = std::make_unique<Silo>(1, Silo::Method::automatic);
    mesh_3->run(600);
    if (refinement == 1)
      return mesh_3;
    auto fine = std::make_unique<Silo>(refinement, Silo::Method::automatic);
    fine->take_velocity(*mesh_3);
    fine->run(20);
    return fine;
  }



  /// ns and bytes of each part of a step.
  template <typename Setting>
  void
  parts_of_step(benchmark::State &state)
  {
    const auto silo  = make_flowing_silo<Setting>(state.range(0));
    auto      &stage = *silo->stage;
    // A whole number of the intervals in which the critical step is found.
    const unsigned int interval = silo->parameters.time_step_interval;
    const unsigned int n_steps =
      interval * (1 + steps_to_measure(*silo) / interval);

    PartSums times(processor_time);
    stage.step_watcher         = &times;
    const unsigned long before = stage.view().totals().particle_steps;
    for (auto _ : state)
      state.SetIterationTime(1e-9 * measure([&]() { silo->run(n_steps); }));
    const double n_particle_steps =
      stage.view().totals().particle_steps - before;

    for (unsigned int part = 0; part < times.sums.size(); ++part)
      state.counters[std::string("ns_of_") + step_part_names[part]] =
        times.sums[part] / n_particle_steps;
    const BytesMoved bytes                   = bytes_moved(*silo);
    state.counters["bytes_of_particles"]     = bytes.particles;
    state.counters["bytes_of_velocity_map"]  = bytes.loop_of_cells;
    state.counters["bytes_of_sums_at_nodes"] = bytes.loop_of_cells;
    state.counters["particles"]              = silo->n_particles();
  }



  /// One interval of the critical step, for callgrind.
  template <typename Setting>
  void
  counted_parts(benchmark::State &state)
  {
    const auto silo = make_flowing_silo<Setting>(1);
    for (auto _ : state)
      {
        CountedParts counter;
        silo->stage->step_watcher = &counter;
        silo->run(silo->parameters.time_step_interval);
        silo->stage->step_watcher = nullptr;
      }
    state.counters["particle_steps"] =
      silo->parameters.time_step_interval * silo->n_particles();
  }



  template <typename Kinematics, CellType cell_type>
  void
  add_benchmarks(const std::string &name)
  {
    using Choice                   = Setting<Kinematics, cell_type>;
    constexpr unsigned int n_pairs = 15;
    benchmark::RegisterBenchmark(("beside_plain_loop/" + name).c_str(),
                                 beside_plain_loop<Choice>)
      ->UseManualTime()
      ->Iterations(n_pairs);
    benchmark::RegisterBenchmark(("defaults_beside_paper/" + name).c_str(),
                                 defaults_beside_paper<Choice>)
      ->UseManualTime()
      ->Iterations(n_pairs);
    benchmark::RegisterBenchmark(("beside_mesh_3/" + name).c_str(),
                                 beside_mesh_3<Choice>)
      ->UseManualTime()
      ->Iterations(n_pairs)
      ->Arg(2)
      ->Arg(4)
      ->Arg(8);
    benchmark::RegisterBenchmark(("parts_of_step/" + name).c_str(),
                                 parts_of_step<Choice>)
      ->UseManualTime()
      ->Iterations(3) // more would empty the silo
      ->Arg(1)
      ->Arg(8);
    if (RUNNING_ON_VALGRIND)
      benchmark::RegisterBenchmark(("counted_parts/" + name).c_str(),
                                   counted_parts<Choice>)
        ->Iterations(1);
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  add_benchmarks<PlaneStrain, CellType::triangle>("plane/triangles");
  add_benchmarks<PlaneStrain, CellType::quadrilateral>("plane/quadrilaterals");
  add_benchmarks<Axisymmetric, CellType::triangle>("axisymmetric/triangles");
  add_benchmarks<Axisymmetric, CellType::quadrilateral>(
    "axisymmetric/quadrilaterals");
  benchmark::RegisterBenchmark("limits/memory_bandwidth",
                               MachineLimits::memory_bandwidth);
  benchmark::RegisterBenchmark("limits/vector_arithmetic",
                               MachineLimits::vector_arithmetic);

  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
}
