#include <sandglass/scene/hopper_slope.h>
#include <sandglass/scene/mesh_size.h>
#include <sandglass/scene/silo_section.h>
#include <sandglass/walls/boundary_role.h>

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Sandglass
{
  namespace
  {
    /**
     * Builds the silo's section from corner points, straight lines and plane
     * surfaces, and remembers the names of what it builds. The section's left
     * end is the axis, or in a whole section the left wall.
     */
    class SiloSection
    {
    public:
      explicit SiloSection(const SceneParameters &parameters)
        : parameters(parameters)
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
      {
        gmsh::model::add("silo");
        if (parameters.cell_type == CellType::triangle)
          add_outlines();
        else
          add_blocks();
        gmsh::model::geo::synchronize();
        if (resolution.is_graded())
          grade_mesh_size(lips,
                          resolution.outlet_element_size,
                          resolution.element_size);
        for (const auto &[name, lines] : lines_named)
          gmsh::model::setPhysicalName(1,
                                       gmsh::model::addPhysicalGroup(1, lines),
                                       name);
        for (const auto &[name, surfaces] : surfaces_named)
          gmsh::model::setPhysicalName(
            2, gmsh::model::addPhysicalGroup(2, surfaces), name);
      }

    private:
      /// Corners of the section that are at one place are one point: an outlet
      /// may reach to the wall, and a hopper to the top.
      int
      point(const double x, const double y)
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

      /// Nothing, called 0, between a point and itself.
      int
      line(const int start, const int end, const BoundaryRole role)
      {
        if (start == end)
          return 0;
        const int tag = gmsh::model::geo::addLine(start, end);
        lines_named[std::string(name_of(role))].push_back(tag);
        return tag;
      }

      int
      inner_line(const int start, const int end)
      {
        return gmsh::model::geo::addLine(start, end);
      }

      /// A line of the left end: of this role in a whole section.
      int
      left_line(const int start, const int end, const BoundaryRole role)
      {
        return line(start, end, is_half ? BoundaryRole::axis : role);
      }

      int
      surface(std::vector<int> lines, const std::string &name)
      {
        lines.erase(std::remove(lines.begin(), lines.end(), 0), lines.end());
        const int tag = gmsh::model::geo::addPlaneSurface(
          {gmsh::model::geo::addCurveLoop(lines)});
        surfaces_named[name].push_back(tag);
        return tag;
      }

      /// Free triangles: one surface for the silo, one for the fall region.
      void
      add_outlines()
      {
        const double e = parameters.hopper_height;
        const double h = parameters.silo_height();

        const int left_lip  = point(outlet_left, 0.);
        const int right_lip = point(outlet_right, 0.);
        lips                = {right_lip};
        if (!is_half)
          lips.push_back(left_lip);
        const int wall_foot = point(right_end, e);
        const int wall_top  = point(right_end, h);
        const int left_top  = point(left_end, h);

        const int outlet = line(left_lip, right_lip, BoundaryRole::outlet);
        std::vector<int> outline = {
          outlet,
          line(right_lip, wall_foot, bottom_role),
          line(wall_foot, wall_top, BoundaryRole::wall),
          line(wall_top, left_top, BoundaryRole::top)};
        if (is_half)
          outline.push_back(line(left_top, left_lip, BoundaryRole::axis));
        else
          {
            const int left_foot = point(left_end, e);
            outline.push_back(line(left_top, left_foot, BoundaryRole::wall));
            outline.push_back(line(left_foot, left_lip, bottom_role));
          }
        surface(outline, material_group);

        if (!parameters.outlet_is_open)
          return;
        const double d            = parameters.fall_region_depth;
        const int    left_bottom  = point(outlet_left, -d);
        const int    right_bottom = point(outlet_right, -d);
        surface({-outlet,
                 left_line(left_lip, left_bottom, BoundaryRole::fall_side),
                 line(left_bottom, right_bottom, BoundaryRole::fall_bottom),
                 line(right_bottom, right_lip, BoundaryRole::fall_side)},
                fall_region_group);
      }

      unsigned int
      n_cells_along(const double length) const
      {
        return std::max(1., std::round(length / resolution.element_size));
      }

      /// A surface of n x m quadrilaterals between four lines.
      void
      block(const int          bottom,
            const int          right,
            const int          top,
            const int          left,
            const unsigned int n,
            const unsigned int m,
            const std::string &name)
      {
        const int tag = surface({bottom, right, top, left}, name);
        for (const int curve : {bottom, top})
          gmsh::model::geo::mesh::setTransfiniteCurve(std::abs(curve), n + 1);
        for (const int curve : {right, left})
          gmsh::model::geo::mesh::setTransfiniteCurve(std::abs(curve), m + 1);
        gmsh::model::geo::mesh::setTransfiniteSurface(tag);
        gmsh::model::geo::mesh::setRecombine(2, tag);
      }

      /// Structured quadrilaterals: blocks between the outlet's and the
      /// hopper's corners.
      void
      add_blocks()
      {
        const int left_lip  = point(outlet_left, 0.);
        const int right_lip = point(outlet_right, 0.);
        const int outlet    = line(left_lip, right_lip, BoundaryRole::outlet);

        const unsigned int n_columns =
          hopper_is_steep(parameters) || parameters.wall_height == 0. ?
            add_hopper_blocks(left_lip, right_lip, outlet) :
            add_columns(left_lip, right_lip, outlet);

        if (!parameters.outlet_is_open)
          return;
        const double d            = parameters.fall_region_depth;
        const int    left_bottom  = point(outlet_left, -d);
        const int    right_bottom = point(outlet_right, -d);
        block(line(left_bottom, right_bottom, BoundaryRole::fall_bottom),
              line(right_bottom, right_lip, BoundaryRole::fall_side),
              -outlet,
              left_line(left_lip, left_bottom, BoundaryRole::fall_side),
              n_columns,
              n_cells_along(d),
              fall_region_group);
      }

      /// One block for the hopper, one above it; returns how many cells wide.
      unsigned int
      add_hopper_blocks(const int left_lip,
                        const int right_lip,
                        const int outlet)
      {
        const double e = parameters.hopper_height;
        const double h = parameters.silo_height();

        const double outlet_width = outlet_right - outlet_left;
        const double width        = right_end - left_end;
        // The longer of the hopper's walls; the axis is shorter than either.
        const double hopper_length =
          std::max(std::hypot(e, right_end - outlet_right),
                   std::hypot(e, left_end - outlet_left));
        const unsigned int n_width =
          std::max(n_cells_along(outlet_width),
                   n_cells_along((width + outlet_width) / 2.));

        const int left_top = point(left_end, h), wall_top = point(right_end, h);
        const int wall_foot  = point(right_end, e);
        const int left_foot  = point(left_end, e);
        const int transition = left_foot == left_top ?
                                 line(left_foot, wall_foot, BoundaryRole::top) :
                                 inner_line(left_foot, wall_foot);
        block(outlet,
              line(right_lip, wall_foot, BoundaryRole::hopper),
              -transition,
              left_line(left_foot, left_lip, BoundaryRole::hopper),
              n_width,
              n_cells_along(hopper_length),
              material_group);
        if (left_foot == left_top)
          return n_width;
        block(transition,
              line(wall_foot, wall_top, BoundaryRole::wall),
              line(wall_top, left_top, BoundaryRole::top),
              left_line(left_top, left_foot, BoundaryRole::wall),
              n_width,
              n_cells_along(parameters.wall_height),
              material_group);
        return n_width;
      }

      /// A block above the outlet, one beside it on each floor or shallow
      /// hopper's wall; returns how many cells wide the outlet is.
      unsigned int
      add_columns(const int left_lip, const int right_lip, const int outlet)
      {
        const double       e        = parameters.hopper_height;
        const double       h        = parameters.silo_height();
        const unsigned int n_outlet = n_cells_along(outlet_right - outlet_left);
        const unsigned int n_height =
          n_cells_along((parameters.wall_height + h) / 2.);

        // Above the outlet's ends.
        const int left_top  = point(outlet_left, h);
        const int right_top = point(outlet_right, h);
        const int wall_foot = point(right_end, e);
        const int left_foot = point(left_end, e);
        const int right     = right_lip == wall_foot ?
                                line(right_lip, right_top, BoundaryRole::wall) :
                                inner_line(right_lip, right_top);
        const int left =
          is_half               ? line(left_top, left_lip, BoundaryRole::axis) :
          left_lip == left_foot ? line(left_top, left_lip, BoundaryRole::wall) :
                                  inner_line(left_top, left_lip);
        block(outlet,
              right,
              line(right_top, left_top, BoundaryRole::top),
              left,
              n_outlet,
              n_height,
              material_group);

        const int wall_top = point(right_end, h);
        if (right_lip != wall_foot)
          block(line(right_lip, wall_foot, bottom_role),
                line(wall_foot, wall_top, BoundaryRole::wall),
                line(wall_top, right_top, BoundaryRole::top),
                -right,
                n_cells_along(std::hypot(e, right_end - outlet_right)),
                n_height,
                material_group);
        if (is_half || left_lip == left_foot)
          return n_outlet;

        const int left_wall_top = point(left_end, h);
        block(line(left_foot, left_lip, bottom_role),
              -left,
              line(left_top, left_wall_top, BoundaryRole::top),
              line(left_wall_top, left_foot, BoundaryRole::wall),
              n_cells_along(std::hypot(e, outlet_left - left_end)),
              n_height,
              material_group);
        return n_outlet;
      }

      const SceneParameters &parameters;
      const Resolution       resolution;

      /// Whether the section ends at the axis.
      const bool is_half;
      /// x of the section's and the outlet's ends, in m.
      const double left_end, right_end, outlet_left, outlet_right;
      /// What lies between outlet and wall.
      const BoundaryRole bottom_role;

      /// Places in m and numbers of the points so far.
      std::vector<std::pair<std::array<double, 2>, int>> points;
      std::vector<int> lips; ///< points where free triangles may be smaller
      std::map<std::string, std::vector<int>> lines_named, surfaces_named;
    };
  } // namespace



  void
  add_silo_section(const SceneParameters &parameters)
  {
    const SiloSection geometry(parameters);
  }
} // namespace Sandglass
