#ifndef sandglass_base_instruction_sets_h
#define sandglass_base_instruction_sets_h

namespace Sandglass
{
  namespace InstructionSets
  {
#if defined(__x86_64__) && !defined(__AVX2__)
    /// All that `kernel` calls is inlined, and so compiled for this target.
    template <typename Kernel>
    __attribute__((target("avx2"), flatten, noinline)) void
    run_with_avx2(Kernel &kernel)
    {
      kernel();
    }
#endif

    template <typename Kernel>
    __attribute__((flatten, noinline)) void
    run_as_built(Kernel &kernel)
    {
      kernel();
    }
  } // namespace InstructionSets

  /**
   * Call `kernel()`, compiled for the widest vectors that this processor has
   * among those that Lanes fill, so that one executable serves all processors
   * well. Without fused multiplications: results are the same on all of them.
   */
  template <typename Kernel>
  void
  run_with_widest_vectors(Kernel &&kernel)
  {
#if defined(__x86_64__) && !defined(__AVX2__)
    if (__builtin_cpu_supports("avx2"))
      {
        InstructionSets::run_with_avx2(kernel);
        return;
      }
#endif
    InstructionSets::run_as_built(kernel);
  }
} // namespace Sandglass

#endif
