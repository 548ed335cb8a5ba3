#ifndef sandglass_material_state_variable_h
#define sandglass_material_state_variable_h

#include <array>
#include <cstddef>

namespace Sandglass
{
  /**
   * A state variable of a law beside stress and density. A law lists its own in
   * `state_variables`; particles store them, hand them on when they change cell
   * or rank or are halved, and checkpoints and VTU files hold them, without
   * another line.
   */
  struct StateVariable
  {
    const char  *name; ///< in VTU files
    const char  *unit; ///< SI; "1" for pure numbers
    unsigned int n_components;
  };

  /// How many numbers a law's state variables are.
  template <typename Law>
  constexpr unsigned int
  n_state_numbers()
  {
    unsigned int n = 0;
    for (std::size_t i = 0; i < Law::state_variables.size(); ++i)
      n += Law::state_variables[i].n_components;
    return n;
  }

  /// A law's state variables at one point, in the order of its list.
  template <typename Law, typename Number>
  using LawState = std::array<Number, n_state_numbers<Law>()>;
} // namespace Sandglass

#endif
