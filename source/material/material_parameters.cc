#include <sandglass/base/parameter_entries.h>
#include <sandglass/material/material_parameters.h>

namespace Sandglass
{
  MaterialParameters::MaterialParameters()
    : ParameterAcceptor("Material")
  {
    using Bounds = BoundedNumber;

    const auto name = [](const auto law) -> std::string {
      return decltype(law)::Type::name;
    };
    const auto description = [](const auto law) -> std::string {
      return decltype(law)::Type::description;
    };
    add_text(*this,
             "Model",
             model,
             dealii::Patterns::Selection(join(AllLaws(), "|", name)),
             "Constitutive law: " + join(AllLaws(), "; ", description) + ".");
    add_number(*this,
               "Density",
               density,
               Bounds::greater_than(0.),
               "kg/m^3",
               "Bulk density of the unstressed material.");
    add_number(*this,
               "Young modulus",
               young_modulus,
               Bounds::greater_than(0.),
               "Pa",
               "Elastic stiffness; the time step goes with its inverse root.");
    add_number(*this,
               "Poisson ratio",
               poisson_ratio,
               Bounds::at_least_below(0., 0.5),
               "1",
               "Poisson ratio.");
    add_number(*this,
               "Internal friction angle",
               internal_friction_angle,
               Bounds::at_least_below(0., 90.),
               "degrees",
               "Angle phi of internal friction; the yield surface's slope is "
               "18 sin(phi) / (9 - sin(phi)^2).");
    add_selection<StressRate>(*this,
                              "Stress rate",
                              stress_rate,
                              {{"Jaumann", StressRate::jaumann}},
                              "Objective stress rate.");
  }

} // namespace Sandglass
