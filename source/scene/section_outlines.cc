#include <sandglass/scene/mesh_size.h>
#include <sandglass/scene/section_parts.h>
#include <sandglass/scene/silo_section.h>

#include <gmsh.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace Sandglass
{
  namespace
  {
    /// Corners on one side of the section from the outlet up, and what the
    /// lines that lead to them are.
    struct Side
    {
      int lip;

      struct Corner
      {
        int          point;
        BoundaryRole role;
      };
      std::vector<Corner> corners;
      /// How many corners the material has.
      unsigned int n_of_material;
    };



    /// @param end  of the material's surface, above or below the foot.
    Side
    side_with_wall(SectionGeometry        &section,
                   const int               lip,
                   const double            x,
                   const dealii::Point<2> &end)
    {
      const double e    = section.parameters.hopper_height;
      Side         side = {lip,
                           {{section.point(x, e), section.bottom_role},
                            {section.point(x, section.filling.top),
                             BoundaryRole::wall}},
                           2};
      if (section.filling.is_top)
        return side;
      const bool is_on_wall = end[1] >= e;
      side.n_of_material    = is_on_wall ? 2 : 1;
      side.corners.insert(side.corners.begin() + side.n_of_material - 1,
                          Side::Corner{section.point(end[0], end[1]),
                                       is_on_wall ? BoundaryRole::wall :
                                                    section.bottom_role});
      return side;
    }



    Side
    side_on_axis(SectionGeometry &section, const int lip)
    {
      const int top = section.point(0., section.filling.top);
      if (section.filling.is_top)
        return {lip, {{top, BoundaryRole::axis}}, 1};
      return {lip,
              {{section.surface_point(0.), BoundaryRole::axis},
               {top, BoundaryRole::axis}},
              1};
    }



    /// Lines up a side, between the corners `first` and `last`.
    std::vector<int>
    lines_up(SectionGeometry   &section,
             const Side        &side,
             const unsigned int first,
             const unsigned int last)
    {
      std::vector<int> lines;
      for (unsigned int i = first; i < last; ++i)
        lines.push_back(
          section.line(i == 0 ? side.lip : side.corners[i - 1].point,
                       side.corners[i].point,
                       side.corners[i].role));
      return lines;
    }



    std::vector<int>
    lines_down(SectionGeometry   &section,
               const Side        &side,
               const unsigned int first,
               const unsigned int last)
    {
      std::vector<int> lines;
      for (unsigned int i = last; i > first; --i)
        lines.push_back(
          section.line(side.corners[i - 1].point,
                       i == 1 ? side.lip : side.corners[i - 2].point,
                       side.corners[i - 1].role));
      return lines;
    }



    void
    append(std::vector<int> &lines, const std::vector<int> &more)
    {
      lines.insert(lines.end(), more.begin(), more.end());
    }



    /// What is empty between the material's surface and the silo's top.
    void
    add_space(SectionGeometry        &section,
              const std::vector<int> &surface,
              const Side             &right,
              const Side             &left)
    {
      std::vector<int> outline;
      std::transform(surface.rbegin(),
                     surface.rend(),
                     std::back_inserter(outline),
                     [](const int line) { return -line; });
      append(
        outline,
        lines_up(section, right, right.n_of_material, right.corners.size()));
      outline.push_back(section.line(right.corners.back().point,
                                     left.corners.back().point,
                                     BoundaryRole::top));
      append(
        outline,
        lines_down(section, left, left.n_of_material, left.corners.size()));
      section.surface(outline, space_group);
    }



    void
    add_fall_region(SectionGeometry &section,
                    const int        outlet,
                    const int        left_lip,
                    const int        right_lip)
    {
      const double d            = section.parameters.fall_region_depth;
      const int    left_bottom  = section.point(section.outlet_left, -d);
      const int    right_bottom = section.point(section.outlet_right, -d);
      section.surface(
        {-outlet,
         section.left_line(left_lip, left_bottom, BoundaryRole::fall_side),
         section.line(left_bottom, right_bottom, BoundaryRole::fall_bottom),
         section.line(right_bottom, right_lip, BoundaryRole::fall_side)},
        fall_region_group);
    }
  } // namespace



  void
  add_outlines(SectionGeometry &section)
  {
    const int        left_lip  = section.point(section.outlet_left, 0.);
    const int        right_lip = section.point(section.outlet_right, 0.);
    std::vector<int> lips      = {right_lip};
    if (!section.is_half)
      lips.push_back(left_lip);
    const Side right = side_with_wall(section,
                                      right_lip,
                                      section.right_end,
                                      section.filling.right);
    section.point(section.left_end, section.filling.top);
    const Side left = section.is_half ? side_on_axis(section, left_lip) :
                                        side_with_wall(section,
                                                       left_lip,
                                                       section.left_end,
                                                       section.filling.left);

    const int outlet = section.line(left_lip, right_lip, BoundaryRole::outlet);
    std::vector<int> outline = {outlet};
    append(outline, lines_up(section, right, 0, right.n_of_material));
    const std::vector<int> surface =
      section.surface_lines(right.corners[right.n_of_material - 1].point,
                            left.corners[left.n_of_material - 1].point);
    append(outline, surface);
    append(outline, lines_down(section, left, 0, left.n_of_material));
    section.surface(outline, material_group);
    if (!section.filling.is_top)
      add_space(section, surface, right, left);
    if (section.parameters.outlet_is_open)
      add_fall_region(section, outlet, left_lip, right_lip);
    gmsh::model::geo::synchronize();
    if (section.resolution.is_graded())
      grade_mesh_size(lips,
                      section.resolution.outlet_element_size,
                      section.resolution.element_size);
  }
} // namespace Sandglass
