#ifndef sandglass_tests_benchmark_machine_limits_h
#define sandglass_tests_benchmark_machine_limits_h

#include <sandglass/base/instruction_sets.h>
#include <sandglass/base/lanes.h>

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

/// What one core of the machine can do at most, with the vectors that the
/// particle loop has.
namespace MachineLimits
{
  using Sandglass::Lanes;

  /// a = b + s c on arrays that no cache holds, in bytes read or written.
  inline void
  memory_bandwidth(benchmark::State &state)
  {
    constexpr std::size_t n = 1 << 22; // 128 MiB each
    std::vector<Lanes>    a(n, 0.), b(n, 1.), c(n, 2.);
    for (auto _ : state)
      {
        Sandglass::run_with_widest_vectors([&]() {
          for (std::size_t i = 0; i < n; ++i)
            a[i] = b[i] + 3. * c[i];
        });
        benchmark::ClobberMemory();
      }
    state.SetBytesProcessed(state.iterations() * 3 * n * sizeof(Lanes));
  }

  /// Multiplications and additions that don't wait for each other, each an
  /// instruction for all of Lanes.
  inline void
  vector_arithmetic(benchmark::State &state)
  {
    constexpr unsigned int n_chains = 12, n_rounds = 1 << 16;
    for (auto _ : state)
      {
        std::array<Lanes, n_chains> chains;
        chains.fill(Lanes(1.));
        Lanes factor(1. - 1e-9), summand(1e-9);
        benchmark::DoNotOptimize(factor);
        benchmark::DoNotOptimize(summand);
        Sandglass::run_with_widest_vectors([&]() {
          auto        own = chains;
          const Lanes f = factor, s = summand;
          for (unsigned int round = 0; round < n_rounds; ++round)
            for (Lanes &chain : own)
              chain = chain * f + s;
          chains = own;
        });
        benchmark::DoNotOptimize(chains);
      }
    const double n_instructions =
      2. * n_chains * n_rounds * static_cast<double>(state.iterations());
    state.counters["vector_instructions_per_second"] =
      benchmark::Counter(n_instructions, benchmark::Counter::kIsRate);
    state.counters["flops_per_second"] =
      benchmark::Counter(n_instructions * Lanes::n,
                         benchmark::Counter::kIsRate);
  }
} // namespace MachineLimits

#endif
