// The particle stage in space, on a square silo in flow: its speed and memory,
// beside a plain loop, and the parts of a step.
//
// Processor time, not wall time; times beside the plain loop are measured in
// pairs, and the counters are the medians.

#include <deal.II/base/mpi.h>

#include <sandglass/continuum/solid.h>

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <fstream>

#include "flowing_box.h"
#include "part_sums.h"
#include "plain_loop.h"

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

  /// What this process holds of the machine's memory, in bytes, without what
  /// the benchmark before has left to be used again.
  double
  resident_memory()
  {
    malloc_trim(0);
    std::ifstream file("/proc/self/statm");
    double        size = 0., resident = 0.;
    file >> size >> resident;
    return resident * 4096.;
  }



  template <typename Setting>
  void
  beside_plain_loop(benchmark::State &state)
  {
    using Silo = FlowingBox<Setting>;
    Silo               silo(state.range(0), Silo::Method::paper);
    PlainLoop<Setting> plain(*silo.scene,
                             silo.material,
                             silo.walls,
                             silo.stage->particles().handler());
    const double       step      = silo.parameters.time_steps[0].second;
    const auto         run_plain = [&](const unsigned int n_steps) {
      for (unsigned int n = 0; n < n_steps; ++n)
        plain.step(step);
    };
    silo.run(200);
    run_plain(200);

    constexpr unsigned int n_steps = 5;
    std::vector<double>    times, ratios;
    for (auto _ : state)
      {
        const unsigned long before = silo.stage->view().totals().particle_steps;
        const double        time   = measure([&]() { silo.run(n_steps); });
        const double        n      = static_cast<double>(
          silo.stage->view().totals().particle_steps - before);
        times.push_back(time / n);
        ratios.push_back(measure([&]() { run_plain(n_steps); }) / time);
        state.SetIterationTime(1e-9 * time);
      }
    state.counters["particles"]                 = silo.n_particles();
    state.counters["ns_per_particle_step"]      = median(times);
    state.counters["particle_steps_per_second"] = 1e9 / median(times);
    state.counters["plain_over_stage"]          = median(ratios);
  }



  /// With the defaults: speed, memory, and ns of each part of a step.
  template <typename Setting>
  void
  parts_of_step(benchmark::State &state)
  {
    using Silo          = FlowingBox<Setting>;
    const double before = resident_memory();
    Silo         silo(state.range(0), Silo::Method::automatic);
    auto        &stage = *silo.stage;
    silo.run(100);

    const unsigned int  n_steps = silo.parameters.time_step_interval;
    PartSums            times(processor_time);
    std::vector<double> times_of_step;
    const unsigned long first = stage.view().totals().particle_steps;
    stage.step_watcher        = &times;
    for (auto _ : state)
      {
        const unsigned long start = stage.view().totals().particle_steps;
        const double        time  = measure([&]() { silo.run(n_steps); });
        times_of_step.push_back(time /
                                (stage.view().totals().particle_steps - start));
        state.SetIterationTime(1e-9 * time);
      }
    stage.step_watcher = nullptr;
    const double n     = stage.view().totals().particle_steps - first;
    for (unsigned int part = 0; part < times.sums.size(); ++part)
      state.counters[std::string("ns_of_") + step_part_names[part]] =
        times.sums[part] / n;
    state.counters["particles"]                 = silo.n_particles();
    state.counters["particle_steps_per_second"] = 1e9 / median(times_of_step);
    state.counters["bytes_per_particle"] =
      (resident_memory() - before) / silo.n_particles();
    state.counters["critical_time_step"] =
      stage.view().critical_time_step(true);
  }



  /// About 0.1, half a million and 4 million particles.
  template <CellType cell_type>
  void
  add_benchmarks(const std::string &name,
                 const unsigned int small,
                 const unsigned int medium,
                 const unsigned int large)
  {
    using Choice = Setting<Solid, cell_type>;
    benchmark::RegisterBenchmark(("beside_plain_loop/" + name).c_str(),
                                 beside_plain_loop<Choice>)
      ->Arg(medium)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(7);
    benchmark::RegisterBenchmark(("parts_of_step/" + name).c_str(),
                                 parts_of_step<Choice>)
      ->Arg(small)
      ->Arg(medium)
      ->Arg(large)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(3);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  add_benchmarks<CellType::hexahedron>("hexahedra", 3, 6, 11);
  add_benchmarks<CellType::tetrahedron>("tetrahedra", 3, 5, 9);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
