#include <sandglass/scene/silo_body.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  using dealii::Point;

  namespace
  {
    Outline
    wall_outline(const SceneParameters &parameters)
    {
      const bool is_round =
        parameters.cross_section == SceneParameters::CrossSection::circle;
      return {is_round,
              parameters.half_width,
              is_round ? parameters.half_width : parameters.whole_half_depth(),
              {}};
    }



    Outline
    outlet_outline(const SceneParameters &parameters)
    {
      const double half_width = parameters.outlet_half_width;
      const bool   is_round =
        parameters.outlet_shape == SceneParameters::OutletShape::circle;
      return {is_round,
              half_width,
              is_round ? half_width :
              parameters.outlet_shape == SceneParameters::OutletShape::slot ?
                         parameters.whole_half_depth() :
                         parameters.outlet_half_depth.value_or(half_width),
              Point<2>(parameters.outlet_eccentricity,
                       parameters.outlet_eccentricity_along_z)};
    }
  } // namespace



  SiloBody::SiloBody(const SceneParameters &parameters)
    : wall(wall_outline(parameters))
    , outlet(outlet_outline(parameters))
    , outlet_is_slot(parameters.outlet_shape ==
                     SceneParameters::OutletShape::slot)
    , hopper_height(parameters.hopper_height)
    , silo_height(parameters.silo_height())
    , fall_region_depth(parameters.fall_region_depth)
    , ends_at_plane(parameters.symmetry_planes())
  {}



  Point<3>
  SiloBody::at(const Point<2> &of_square, const double y) const
  {
    const double share =
      has_hopper() ? std::clamp(y / hopper_height, 0., 1.) : 1.;
    const Point<2> plan = outlet.at(of_square) +
                          share * (wall.at(of_square) - outlet.at(of_square));
    return Point<3>(plan[0], y, plan[1]);
  }



  double
  SiloBody::filled_volume() const
  {
    const double top = wall.area(), bottom = outlet.area();
    return top * (silo_height - hopper_height) +
           hopper_height / 3. * (top + bottom + std::sqrt(top * bottom));
  }



  double
  SiloBody::distance_from_lip(const Point<3> &point) const
  {
    const double in_plan =
      outlet_is_slot ?
        std::abs(std::abs(point[0] - outlet.middle[0]) - outlet.half_width) :
        outlet.distance(Point<2>(point[0], point[2]));
    return std::hypot(in_plan, point[1]);
  }
} // namespace Sandglass
