#include <sandglass/run/declared_parameters.h>
#include <sandglass/run/settings_without_effect.h>

#include <algorithm>

namespace Sandglass
{
  using dealii::ParameterHandler;

  namespace
  {
    /// Parameters that are read only where another one has one of these values.
    struct Dependence
    {
      std::string              section;
      std::vector<std::string> names; ///< empty: all of the section
      std::string              section_of_chooser, chooser;
      std::vector<std::string> values;
    };

    const std::vector<Dependence> dependences = {
      {"Scene", {"Mesh file"}, "Scene", "Shape", {"mesh file"}},
      {"Scene", {"Layers"}, "Scene", "Filling", {"in layers"}},
      {"Scene",
       {"Cross section",
        "Half depth",
        "Outlet shape",
        "Outlet half depth",
        "Outlet eccentricity along z",
        "Symmetry planes"},
       "Scene",
       "Formulation",
       {"three dimensions"}},
      {"Material",
       {"UMAT library", "UMAT constants", "UMAT state variables"},
       "Material",
       "Model",
       {"UMAT"}},
      {"Updated Lagrangian stage",
       {},
       "Flow",
       "Method",
       {"updated Lagrangian"}},
      {"Feed", {"Rate", "Speed"}, "Feed", "Kind", {"rain"}},
      {"Feed",
       {"Opening left", "Opening right", "Start time", "End time"},
       "Feed",
       "Kind",
       {"level", "rain"}}};



    bool
    concerns(const Dependence &dependence, const DeclaredParameter &parameter)
    {
      const auto &names = dependence.names;
      return parameter.section == dependence.section &&
             (names.empty() ||
              std::find(names.begin(), names.end(), parameter.name) !=
                names.end());
    }



    std::string
    value_of(const std::string                    &section,
             const std::string                    &name,
             const std::vector<DeclaredParameter> &parameters)
    {
      const auto found = std::find_if(parameters.begin(),
                                      parameters.end(),
                                      [&](const DeclaredParameter &parameter) {
                                        return parameter.section == section &&
                                               parameter.name == name;
                                      });
      return found == parameters.end() ? "" : found->value;
    }



    std::string
    in_words(const std::vector<std::string> &values)
    {
      std::string words;
      for (const std::string &value : values)
        words += (words.empty() ? "" : " or ") + value;
      return words;
    }
  } // namespace



  std::vector<std::string>
  settings_without_effect(const ParameterHandler &prm)
  {
    const auto               parameters = declared_parameters(prm);
    std::vector<std::string> warnings;
    for (const DeclaredParameter &parameter : parameters)
      for (const Dependence &dependence : dependences)
        {
          if (parameter.value == parameter.default_value ||
              !concerns(dependence, parameter))
            continue;
          const auto       &values = dependence.values;
          const std::string chosen = value_of(dependence.section_of_chooser,
                                              dependence.chooser,
                                              parameters);
          if (std::find(values.begin(), values.end(), chosen) == values.end())
            warnings.push_back(
              parameter.section + '/' + parameter.name + " = " +
              parameter.value + " has no effect: it takes " +
              dependence.section_of_chooser + '/' + dependence.chooser + " = " +
              in_words(values) + '.');
        }
    return warnings;
  }
} // namespace Sandglass
