#ifndef sandglass_output_small_sine_h
#define sandglass_output_small_sine_h

namespace Sandglass
{
  /// Sines of angles below this are zero: of walls that a user has drawn as
  /// vertical or level.
  constexpr double small_sine = 1e-3;
} // namespace Sandglass

#endif
