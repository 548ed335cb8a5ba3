#ifndef sandglass_output_reference_pressures_h
#define sandglass_output_reference_pressures_h

#include <sandglass/material/material_parameters.h>
#include <sandglass/output/body_vertical_part.h>
#include <sandglass/output/eurocode_pressures.h>
#include <sandglass/output/janssen.h>
#include <sandglass/output/output_parameters.h>
#include <sandglass/output/section_vertical_part.h>

#include <type_traits>

namespace Sandglass
{
  /// Formulas' pressures at the walls of a section, or of a silo in three
  /// dimensions, NaN wherever a formula does not apply.
  template <int dim>
  class ReferencePressures
  {
  public:
    ReferencePressures(const OutputParameters   &parameters,
                       const Scene<dim>         &scene,
                       const MaterialParameters &material);

    /// Janssen's at a wall's node, in Pa.
    double
    janssen_normal(const WallRecord &record) const;

    /// Likewise those of EN 1991-4.
    WallPressure
    eurocode(const EurocodePressures::Load load,
             const WallRecord             &record) const;

    /// What its patch loads add to that on vertical walls, in Pa; NaN in
    /// three dimensions, where they act on a part of the circumference.
    double
    eurocode_patch(const EurocodePressures::Load load,
                   const WallRecord             &record) const;

  private:
    using Part = std::conditional_t<dim == 2, VerticalPart, BodyVerticalPart>;

    const Part              part;
    const Janssen           janssen;
    const EurocodePressures standard;
  };
} // namespace Sandglass

#endif
