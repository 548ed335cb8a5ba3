#include <sandglass/base/number_text.h>
#include <sandglass/scene/body_surface.h>
#include <sandglass/scene/fill_surface.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  using dealii::Point;

  namespace
  {
    /// Of the places of the cross section from its middle, in m.
    double
    mean_distance(const Outline &wall)
    {
      if (wall.is_round)
        return 2. / 3. * wall.half_width;
      // The midpoint rule, to some 1e-5
      constexpr unsigned int n   = 100;
      double                 sum = 0.;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          sum += std::hypot((i + 0.5) / n * wall.half_width,
                            (j + 0.5) / n * wall.half_depth);
      return sum / (n * n);
    }



    double
    farthest_distance(const Outline &wall)
    {
      return wall.is_round ? wall.half_width :
                             std::hypot(wall.half_width, wall.half_depth);
    }



    FillSurface<3>
    surface_of(const SiloBody &body, const SceneParameters &parameters)
    {
      return {{0.,
               body.wall.half_width,
               parameters.silo_height(),
               mean_distance(body.wall)},
              parameters};
    }
  } // namespace



  SiloBody
  filled_part(const SiloBody &body, const SceneParameters &parameters)
  {
    if (is_full(parameters))
      return body;
    // So that cells below the surface are not pressed flat
    constexpr double lowest_share = 0.2;

    SiloBody part    = body;
    part.silo_height = parameters.fill_height.value_or(body.silo_height);
    const FillSurface<3> surface = surface_of(body, parameters);
    const double         at_wall =
      surface.height(Point<3>(farthest_distance(body.wall), 0., 0.));
    const double above_hopper = part.silo_height - body.hopper_height;
    if (at_wall <= body.hopper_height + lowest_share * above_hopper)
      refuse_fill_height(
        parameters,
        "the surface meets the wall at " + number_text(at_wall) +
          " m; allowed in three dimensions is one that does so well above "
          "the hopper or floor, which ends at " +
          number_text(body.hopper_height) + " m");
    return part;
  }



  void
  move_to_surface(Mesh<3>               &mesh,
                  const SiloBody        &body,
                  const SceneParameters &parameters)
  {
    if (is_full(parameters))
      return;
    const FillSurface<3> surface = surface_of(body, parameters);
    const double         bottom  = body.hopper_height;
    for (Point<3> &vertex : mesh.vertices)
      if (vertex[1] > bottom)
        vertex[1] = bottom + (vertex[1] - bottom) /
                               (body.silo_height - bottom) *
                               (surface.height(vertex) - bottom);
  }
} // namespace Sandglass
