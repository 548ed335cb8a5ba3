#include <sandglass/choices/choose_law.h>
#include <sandglass/material/chosen_law.h>

namespace Sandglass
{
  std::vector<StateVariable>
  state_variables_of_law(const MaterialConstants &constants)
  {
    std::vector<StateVariable> variables;
    choose_law(constants, [&variables](const auto law) {
      using Law = typename decltype(law)::Type;
      variables.assign(Law::state_variables.begin(),
                       Law::state_variables.end());
    });
    return variables;
  }



  bool
  dissipation_can_fall(const MaterialConstants &constants)
  {
    bool result = false;
    choose_law(constants, [&result](const auto law) {
      result = decltype(law)::Type::dissipation_can_fall;
    });
    return result;
  }
} // namespace Sandglass
