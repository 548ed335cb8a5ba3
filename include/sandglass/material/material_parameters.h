#ifndef sandglass_material_material_parameters_h
#define sandglass_material_material_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <sandglass/material/drucker_prager.h>

namespace Sandglass
{
  /// Section `Material`: the stored material's properties.
  class MaterialParameters : public dealii::ParameterAcceptor
  {
  public:
    MaterialParameters();

    enum class Model
    {
      drucker_prager
    };

    enum class StressRate
    {
      jaumann
    };

    Model      model                   = Model::drucker_prager;
    double     density                 = 1500.; ///< in kg/m^3
    double     young_modulus           = 1e6;   ///< in Pa
    double     poisson_ratio           = 0.3;
    double     internal_friction_angle = 25.; ///< in degrees
    StressRate stress_rate             = StressRate::jaumann;

    Elasticity
    elasticity() const
    {
      return {young_modulus, poisson_ratio};
    }

    DruckerPrager
    drucker_prager() const;
  };
} // namespace Sandglass

#endif
