#ifndef sandglass_material_material_parameters_h
#define sandglass_material_material_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <sandglass/choices.h>

#include <string>

namespace Sandglass
{
  /// Section `Material`: the stored material's properties.
  class MaterialParameters : public dealii::ParameterAcceptor,
                             public MaterialConstants
  {
  public:
    MaterialParameters();

    enum class StressRate
    {
      jaumann
    };

    /// Name of the law.
    std::string model       = DruckerPrager::name;
    StressRate  stress_rate = StressRate::jaumann;
  };
} // namespace Sandglass

#endif
