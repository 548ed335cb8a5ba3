#ifndef sandglass_base_prefetch_h
#define sandglass_base_prefetch_h

namespace Sandglass
{
  /// How many turns of a loop ahead its data are fetched; half of it is as
  /// good.
  constexpr unsigned int prefetch_distance = 8;

  /// Fetch an object into the cache, where the processor doesn't foresee that
  /// it is needed soon. If the object doesn't begin with a cache line, its end
  /// may be left out: fetching one more line costs more than it gains.
  template <typename T>
  void
  prefetch(const T &object)
  {
    constexpr unsigned int line  = 64; // bytes
    const char *const      start = reinterpret_cast<const char *>(&object);
    for (unsigned int byte = 0; byte < sizeof(T); byte += line)
      __builtin_prefetch(start + byte, 1);
  }
} // namespace Sandglass

#endif
