#ifndef sandglass_output_body_reference_pressures_h
#define sandglass_output_body_reference_pressures_h

#include <sandglass/material/material_parameters.h>
#include <sandglass/output/body_vertical_part.h>
#include <sandglass/output/eurocode_pressures.h>
#include <sandglass/output/janssen.h>
#include <sandglass/output/output_parameters.h>

namespace Sandglass
{
  /// Formulas' pressures at the walls of a silo in three dimensions, NaN
  /// wherever a formula does not apply.
  class BodyReferencePressures
  {
  public:
    BodyReferencePressures(const OutputParameters   &parameters,
                           const Scene<3>           &scene,
                           const MaterialParameters &material);

    /// Janssen's at a wall's node, in Pa.
    double
    janssen_normal(const WallRecord &record) const;

    /// Likewise those of EN 1991-4.
    WallPressure
    eurocode(const EurocodePressures::Load load,
             const WallRecord             &record) const;

  private:
    const BodyVerticalPart  part;
    const Janssen           janssen;
    const EurocodePressures standard;
  };
} // namespace Sandglass

#endif
