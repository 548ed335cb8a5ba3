#ifndef sandglass_scene_section_geometry_h
#define sandglass_scene_section_geometry_h

#include <sandglass/scene/scene_parameters.h>
#include <sandglass/scene/section_surface.h>
#include <sandglass/walls/boundary_role.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Sandglass
{
  /**
   * Builds a silo's section in Gmsh from corner points, straight lines and
   * plane surfaces, and remembers the names of what it builds. The section's
   * left end is the axis, or in a whole section the left wall.
   *
   * Lines are known by their tags, which are negative where a line is followed
   * from its end to its start.
   */
  class SectionGeometry
  {
  public:
    SectionGeometry(const SceneParameters &parameters,
                    const SectionSurface  &filling);

    /// Corners of the section that are at one place are one point: an outlet
    /// may reach to the wall, and a hopper to the top.
    int
    point(const double x, const double y);

    /// Nothing, called 0, between a point and itself.
    int
    line(const int start, const int end, const BoundaryRole role);

    /// Without a name.
    int
    inner_line(const int start, const int end);

    /// A line of the left end: of this role in a whole section.
    int
    left_line(const int start, const int end, const BoundaryRole role);

    /// The surface inside a closed loop of lines.
    int
    surface(std::vector<int> lines, const std::string &name);

    /// The material's surface or the section's top, from one point to another
    /// on its left: one line, or two with the apex between them.
    std::vector<int>
    surface_lines(const int right, const int left);

    /// Whether surface_lines() of points at these x has the apex between them.
    bool
    has_apex_between(const double left, const double right) const;

    /// The material's surface above an x, as a point.
    int
    surface_point(const double x);

    int
    start_of(const int line) const;

    int
    end_of(const int line) const;

    double
    length_of(const int line) const;

    /// Of a point, in m.
    std::array<double, 2>
    place_of(const int point) const;

    /// Make the lines and surfaces of one name one physical group.
    void
    name_groups() const;

    const SceneParameters &parameters;
    const SectionSurface  &filling;
    const Resolution       resolution;

    /// Whether the section ends at the axis.
    const bool is_half;
    /// x of the section's and the outlet's ends, in m.
    const double left_end, right_end, outlet_left, outlet_right;
    /// What lies between outlet and wall.
    const BoundaryRole bottom_role;

  private:
    /// Places in m and numbers of the points so far.
    std::vector<std::pair<std::array<double, 2>, int>> points;
    /// Start and end of each line.
    std::map<int, std::array<int, 2>>       ends_of_line;
    std::map<std::string, std::vector<int>> lines_named, surfaces_named;
  };
} // namespace Sandglass

#endif
