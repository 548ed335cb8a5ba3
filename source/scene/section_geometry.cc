#include <sandglass/scene/section_geometry.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  SectionGeometry::SectionGeometry(const SceneParameters &parameters,
                                   const SectionSurface  &filling)
    : parameters(parameters)
    , filling(filling)
    , resolution(parameters.resolution())
    , is_half(parameters.is_symmetric)
    , left_end(is_half ? 0. : -parameters.half_width)
    , right_end(parameters.half_width)
    , outlet_left(is_half ? 0. :
                            parameters.outlet_eccentricity -
                              parameters.outlet_half_width)
    , outlet_right(parameters.outlet_eccentricity +
                   parameters.outlet_half_width)
    , bottom_role(parameters.hopper_height > 0. ? BoundaryRole::hopper :
                                                  BoundaryRole::floor)
  {}



  int
  SectionGeometry::point(const double x, const double y)
  {
    const double rounding = 1e-9 * parameters.half_width;
    for (const auto &[position, tag] : points)
      if (std::hypot(position[0] - x, position[1] - y) < rounding)
        return tag;
    const int tag =
      gmsh::model::geo::addPoint(x, y, 0., resolution.element_size);
    points.push_back({{{x, y}}, tag});
    return tag;
  }



  int
  SectionGeometry::line(const int start, const int end, const BoundaryRole role)
  {
    if (start == end)
      return 0;
    const int tag = inner_line(start, end);
    lines_named[std::string(name_of(role))].push_back(tag);
    return tag;
  }



  int
  SectionGeometry::inner_line(const int start, const int end)
  {
    const int tag     = gmsh::model::geo::addLine(start, end);
    ends_of_line[tag] = {{start, end}};
    return tag;
  }



  int
  SectionGeometry::left_line(const int          start,
                             const int          end,
                             const BoundaryRole role)
  {
    return line(start, end, is_half ? BoundaryRole::axis : role);
  }



  int
  SectionGeometry::surface(std::vector<int> lines, const std::string &name)
  {
    lines.erase(std::remove(lines.begin(), lines.end(), 0), lines.end());
    const int tag = gmsh::model::geo::addPlaneSurface(
      {gmsh::model::geo::addCurveLoop(lines)});
    surfaces_named[name].push_back(tag);
    return tag;
  }



  std::vector<int>
  SectionGeometry::surface_lines(const int right, const int left)
  {
    if (!has_apex_between(place_of(left)[0], place_of(right)[0]))
      return {line(right, left, BoundaryRole::top)};
    const int apex = surface_point(0.);
    return {line(right, apex, BoundaryRole::top),
            line(apex, left, BoundaryRole::top)};
  }



  bool
  SectionGeometry::has_apex_between(const double left, const double right) const
  {
    const double rounding = 1e-9 * parameters.half_width;
    return parameters.surface_slope > 0. && left < -rounding &&
           right > rounding;
  }



  int
  SectionGeometry::surface_point(const double x)
  {
    return point(x, filling.line.height(dealii::Point<2>(x, 0.)));
  }



  int
  SectionGeometry::start_of(const int line) const
  {
    return ends_of_line.at(std::abs(line))[line > 0 ? 0 : 1];
  }



  int
  SectionGeometry::end_of(const int line) const
  {
    return start_of(-line);
  }



  double
  SectionGeometry::length_of(const int line) const
  {
    const auto &[start, end] = ends_of_line.at(std::abs(line));
    const auto a = place_of(start), b = place_of(end);
    return std::hypot(a[0] - b[0], a[1] - b[1]);
  }



  std::array<double, 2>
  SectionGeometry::place_of(const int point) const
  {
    return std::find_if(points.begin(),
                        points.end(),
                        [point](const auto &entry) {
                          return entry.second == point;
                        })
      ->first;
  }



  void
  SectionGeometry::name_groups() const
  {
    for (const auto &[name, lines] : lines_named)
      gmsh::model::setPhysicalName(1,
                                   gmsh::model::addPhysicalGroup(1, lines),
                                   name);
    for (const auto &[name, surfaces] : surfaces_named)
      gmsh::model::setPhysicalName(2,
                                   gmsh::model::addPhysicalGroup(2, surfaces),
                                   name);
  }
} // namespace Sandglass
