#ifndef sandglass_material_law_defaults_h
#define sandglass_material_law_defaults_h

#include <sandglass/material/law_constant.h>
#include <sandglass/material/state_variable.h>

#include <array>

namespace Sandglass
{
  /// What a law is that says nothing else: laws derive from this class, and
  /// declare anew what is different.
  struct LawDefaults
  {
    static constexpr std::array<StateVariable, 0> state_variables = {};
    static constexpr std::array<LawConstant, 0>   law_constants   = {};

    /// Whether Material/Cohesion is for it.
    static constexpr bool has_cohesion = false;

    /// Whether stiffness_bound() is the same for all states.
    static constexpr bool has_constant_stiffness = true;

    /// Whether correct() may throw LawFailure.
    static constexpr bool can_fail = false;

    /// Whether it can't tell elastic energy from what is dissipated.
    static constexpr bool dissipation_can_fall = false;

    /// Whether the law itself says how loose material can be that has stress.
    static constexpr bool knows_density = false;

    /// Whether particles may take the volumetric strain of their cells'
    /// neighbourhood.
    static constexpr bool takes_averaged_strain = true;
  };
} // namespace Sandglass

#endif
