#ifndef sandglass_choices_choose_law_h
#define sandglass_choices_choose_law_h

#include <sandglass/choices/all_laws.h>
#include <sandglass/material/material_constants.h>

/**
 * @file
 * The choice among what cmake/choices.cmake lists, the one table of
 * compile-time choices: laws.
 */

namespace Sandglass
{
  /// The objective rate by which a law's stress turns; Jaumann's, unless the
  /// law says another one.
  template <typename Law>
  constexpr StressRate stress_rate_of = StressRate::jaumann;

  template <typename Law>
  constexpr StressRate stress_rate_of<GreenNaghdi<Law>> =
    StressRate::green_naghdi;

  /// Whether a law is for grids of this dimension; Green and Naghdi's rate is
  /// for the plane only.
  template <int dim, typename Law>
  constexpr bool is_law_in =
    dim == 2 || stress_rate_of<Law> == StressRate::jaumann;

  /// Call `function(TypeTag<Law>())` for the law that the constants ask for.
  /// @return whether there is one.
  template <typename Function>
  bool
  choose_law(const MaterialConstants &constants, const Function &function)
  {
    return choose(
      AllLaws(),
      [&constants](const auto law) {
        using Law = typename decltype(law)::Type;
        return Law::is_meant(constants) &&
               stress_rate_of<Law> == constants.stress_rate;
      },
      function);
  }

  /// The same for a law in this dimension.
  template <int dim, typename Function>
  bool
  choose_law_in(const MaterialConstants &constants, const Function &function)
  {
    bool is_found = false;
    choose_law(constants, [&](const auto law) {
      if constexpr (is_law_in<dim, typename decltype(law)::Type>)
        {
          function(law);
          is_found = true;
        }
    });
    return is_found;
  }
} // namespace Sandglass

#endif
