#ifndef sandglass_continuum_stress_integration_h
#define sandglass_continuum_stress_integration_h

namespace Sandglass
{
  /// The configuration in which a step's strain and rotation are taken.
  enum class StressIntegration
  {
    start_of_step, ///< first order, as in the paper (Section 4.1)
    middle_of_step ///< second order; a rigid rotation leaves no strain
  };
} // namespace Sandglass

#endif
