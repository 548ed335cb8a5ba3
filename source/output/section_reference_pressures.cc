#include <deal.II/base/numbers.h>

#include <sandglass/output/section_reference_pressures.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Sandglass
{
  namespace
  {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

    /// What material lets a wall have: on a rougher one it slips in itself,
    /// since no plane in it bears more friction than tan(phi).
    double
    borne_friction(const double              wall_friction,
                   const MaterialParameters &material)
    {
      return std::min(wall_friction,
                      std::tan(material.internal_friction_angle * numbers::PI /
                               180.));
    }



    Janssen
    make_janssen(const OutputParameters   &parameters,
                 const Scene<2>           &scene,
                 const MaterialParameters &material,
                 const VerticalPart       &part)
    {
      return {material.density * scene.gravity.norm(),
              part.hydraulic_radius,
              parameters.lateral_pressure_ratio > 0. ?
                parameters.lateral_pressure_ratio :
                Janssen::standard_lateral_pressure_ratio(
                  material.internal_friction_angle),
              borne_friction(part.friction_coefficient.value_or(nothing),
                             material)};
    }



    EurocodePressures::Silo
    make_silo(const OutputParameters   &parameters,
              const Scene<2>           &scene,
              const MaterialParameters &material,
              const VerticalPart       &part)
    {
      EurocodePressures::Silo silo{scene.formulation,
                                   part.is_plain ? part.width : 0.,
                                   part.top - part.foot,
                                   part.outlet_eccentricity,
                                   part.hopper_slope,
                                   material.internal_friction_angle};
      if (part.hopper_friction_coefficient)
        silo.hopper_friction_coefficient =
          borne_friction(*part.hopper_friction_coefficient, material);
      silo.patch_load_factor = parameters.patch_load_factor;
      return silo;
    }
  } // namespace



  ReferencePressures::ReferencePressures(const OutputParameters   &parameters,
                                         const Scene<2>           &scene,
                                         const MaterialParameters &material)
    : part(scene)
    , janssen(make_janssen(parameters, scene, material, part))
    , standard(make_silo(parameters, scene, material, part), janssen)
  {}



  double
  ReferencePressures::janssen_normal(const WallRecord &record) const
  {
    if (!part.friction_coefficient)
      return nothing;
    const double depth = part.top - record.position[1];
    return part.has_wall(record)   ? janssen.horizontal_pressure(depth) :
           part.has_bottom(record) ? janssen.vertical_pressure(depth) :
                                     nothing;
  }



  WallPressure
  ReferencePressures::eurocode(const EurocodePressures::Load load,
                               const WallRecord             &record) const
  {
    if (!part.friction_coefficient)
      return {};
    const double depth = part.top - record.position[1];
    return part.has_wall(record)   ? standard.on_wall(load, depth) :
           part.has_hopper(record) ? standard.on_hopper(load, depth) :
                                     WallPressure();
  }



  double
  ReferencePressures::eurocode_patch(const EurocodePressures::Load load,
                                     const WallRecord             &record) const
  {
    return part.friction_coefficient && part.has_wall(record) ?
             standard.patch(load, part.top - record.position[1]) :
             nothing;
  }
} // namespace Sandglass
