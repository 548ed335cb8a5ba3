#include <deal.II/base/numbers.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/output/reference_pressures.h>

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



    template <int dim, typename Part>
    Janssen
    make_janssen(const OutputParameters   &parameters,
                 const Scene<dim>         &scene,
                 const MaterialParameters &material,
                 const Part               &part)
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



    template <typename Part>
    EurocodePressures::Silo
    make_silo(const Formulation         formulation,
              const double              width,
              const MaterialParameters &material,
              const Part               &part)
    {
      EurocodePressures::Silo silo{formulation,
                                   width,
                                   part.top - part.foot,
                                   part.outlet_eccentricity,
                                   part.hopper_slope,
                                   material.internal_friction_angle};
      if (part.hopper_friction_coefficient)
        silo.hopper_friction_coefficient =
          borne_friction(*part.hopper_friction_coefficient, material);
      return silo;
    }



    EurocodePressures::Silo
    make_silo(const OutputParameters   &parameters,
              const Scene<2>           &scene,
              const MaterialParameters &material,
              const VerticalPart       &part)
    {
      EurocodePressures::Silo silo = make_silo(scene.formulation,
                                               part.is_plain ? part.width : 0.,
                                               material,
                                               part);
      silo.patch_load_factor       = parameters.patch_load_factor;
      return silo;
    }



    /// The standard's hoppers are wedges, or cones and square pyramids.
    EurocodePressures::Silo
    make_silo(const OutputParameters &,
              const Scene<3> &,
              const MaterialParameters &material,
              const BodyVerticalPart   &part)
    {
      return make_silo(part.hopper_is_wedge ? Formulation::plane_strain :
                                              Formulation::axisymmetric,
                       part.width,
                       material,
                       part);
    }
  } // namespace



  template <int dim>
  ReferencePressures<dim>::ReferencePressures(
    const OutputParameters   &parameters,
    const Scene<dim>         &scene,
    const MaterialParameters &material)
    : part(scene)
    , janssen(make_janssen(parameters, scene, material, part))
    , standard(make_silo(parameters, scene, material, part), janssen)
  {}



  template <int dim>
  double
  ReferencePressures<dim>::janssen_normal(const WallRecord &record) const
  {
    if (!part.friction_coefficient)
      return nothing;
    const double depth = part.top - record.position[1];
    return part.has_wall(record)   ? janssen.horizontal_pressure(depth) :
           part.has_bottom(record) ? janssen.vertical_pressure(depth) :
                                     nothing;
  }



  template <int dim>
  WallPressure
  ReferencePressures<dim>::eurocode(const EurocodePressures::Load load,
                                    const WallRecord             &record) const
  {
    if (!part.friction_coefficient)
      return {};
    const double depth = part.top - record.position[1];
    return part.has_wall(record)   ? standard.on_wall(load, depth) :
           part.has_hopper(record) ? standard.on_hopper(load, depth) :
                                     WallPressure();
  }



  template <int dim>
  double
  ReferencePressures<dim>::eurocode_patch(const EurocodePressures::Load load,
                                          const WallRecord &record) const
  {
    // In three dimensions the height alone does not tell where they act.
    return dim == 2 && part.friction_coefficient && part.has_wall(record) ?
             standard.patch(load, part.top - record.position[1]) :
             nothing;
  }



#define INSTANTIATE(dim) template class ReferencePressures<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
