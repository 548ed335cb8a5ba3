#ifndef sandglass_material_material_parameters_h
#define sandglass_material_material_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <sandglass/base/parameter_entries.h>
#include <sandglass/material/material_constants.h>

#include <string>

namespace Sandglass
{
  /// Section `Material`: the stored material's properties.
  class MaterialParameters : public dealii::ParameterAcceptor,
                             public MaterialConstants
  {
  public:
    MaterialParameters();

    /// Hand the constants to the law, and throw InputError unless it has what
    /// is set.
    void
    check();

    /// Of dilatational waves in m/s, if the law's stiffness is constant; 0:
    /// it depends on the stress.
    double
    wave_speed() const;

    /// As they are in the parameter file.
    NamedNumbers given_law_constants;
  };
} // namespace Sandglass

#endif
