#include <sandglass/base/exceptions.h>
#include <sandglass/base/number_text.h>
#include <sandglass/scene/section_surface.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace Sandglass
{
  using dealii::Point;

  namespace
  {
    /**
     * Where a surface ends on one side of the silo's middle.
     *
     * @param lip   end of the outlet on this side,
     * @param foot  of the vertical wall.
     */
    Point<2>
    end_of(const FillSurface<2>  &surface,
           const Point<2>        &lip,
           const Point<2>        &foot,
           const SceneParameters &silo)
    {
      const double at_wall = surface.height(foot);
      if (at_wall >= foot[1] && at_wall > 0.)
        return Point<2>(foot[0], at_wall);
      // The line is straight between the middle and the wall.
      const bool     reaches_beyond_middle = lip[0] * foot[0] < 0.;
      const Point<2> start =
        reaches_beyond_middle ?
          Point<2>(0., foot[1] * lip[0] / (lip[0] - foot[0])) :
          lip;
      const double above = surface.height(start) - start[1];
      if (foot[1] == 0. || above <= 0.)
        refuse_fill_height(
          silo,
          std::string("the material must cover the ") +
            (foot[1] == 0. ? "floor" : "outlet") +
            " from end to end: allowed are with this Surface slope more than " +
            number_text(*silo.fill_height -
                        (foot[1] == 0. ? at_wall : surface.height(start))) +
            " m");
      const double share = above / (above + foot[1] - at_wall);
      return start + share * (foot - start);
    }
  } // namespace



  SectionSurface
  section_surface(const SceneParameters &silo)
  {
    const double         top = silo.silo_height();
    const FillSurface<2> line({0., silo.half_width, top}, silo);
    const double         size = silo.resolution().element_size;
    if (silo.fill_height && *silo.fill_height < size)
      refuse_fill_height(
        silo,
        "no cell lies below the surface: allowed is at least the "
        "Element size of " +
          number_text(size) + " m");

    const double apex = line.height(Point<2>());
    const double gap  = top - apex;
    // A section that ended in the hopper would need its width there.
    const bool is_top =
      silo.surface_slope == 0. && gap < size / 2. && apex >= silo.hopper_height;
    const Point<2> left_wall(-silo.half_width, silo.hopper_height);
    const Point<2> right_wall(silo.half_width, silo.hopper_height);
    if (is_top)
      return {line,
              true,
              apex,
              Point<2>(silo.is_symmetric ? 0. : left_wall[0], apex),
              Point<2>(right_wall[0], apex)};
    if (silo.surface_slope > 0. && gap < size / 2.)
      refuse_fill_height(silo,
                         "the heap's apex must lie below the silo's top at " +
                           number_text(top) +
                           " m by half an Element size: allowed are at most " +
                           number_text(*silo.fill_height + gap - size / 2.) +
                           " m");

    const double   middle = silo.outlet_eccentricity;
    const Point<2> left_lip(middle - silo.outlet_half_width, 0.);
    const Point<2> right_lip(middle + silo.outlet_half_width, 0.);
    return {line,
            false,
            top,
            silo.is_symmetric ? Point<2>(0., apex) :
                                end_of(line, left_lip, left_wall, silo),
            end_of(line, right_lip, right_wall, silo)};
  }
} // namespace Sandglass
