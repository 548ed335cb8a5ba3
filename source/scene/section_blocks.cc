#include <sandglass/scene/hopper_slope.h>
#include <sandglass/scene/section_block.h>
#include <sandglass/scene/section_parts.h>
#include <sandglass/scene/silo_section.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Sandglass
{
  namespace
  {
    using Lines = SectionLines;

    class SectionBlocks
    {
    public:
      explicit SectionBlocks(SectionGeometry &section)
        : section(section)
        , filling(section.filling)
        , e(section.parameters.hopper_height)
      {}

      void
      add()
      {
        const int left_lip  = section.point(section.outlet_left, 0.);
        const int right_lip = section.point(section.outlet_right, 0.);
        const int outlet =
          section.line(left_lip, right_lip, BoundaryRole::outlet);

        const unsigned int n_columns =
          hopper_is_steep(section.parameters) ||
              section.parameters.wall_height == 0. || wall_is_low() ?
            add_hopper_blocks(left_lip, right_lip, outlet) :
            add_columns(left_lip, right_lip, outlet);
        if (!filling.is_top)
          add_space_blocks(section, tops);
        if (section.parameters.outlet_is_open)
          add_fall_region(left_lip, right_lip, outlet, n_columns);
        gmsh::model::geo::synchronize();
      }

    private:
      unsigned int
      n_cells_along(const double length) const
      {
        return Sandglass::n_cells_along(section, length);
      }

      /// Whether the material's surface meets the hopper, or the wall within a
      /// cell above it.
      bool
      wall_is_low() const
      {
        return !filling.is_top && e > 0. &&
               filling.right[1] < e + section.resolution.element_size;
      }

      /// Lines from right to left that are the top of a block, which the empty
      /// one above it finds here.
      Lines
      top_of_block(const int right, const int left, const unsigned int n)
      {
        tops.push_back({section.surface_lines(right, left), right, left, n});
        return tops.back().lines;
      }

      /// Cells across a block between these x, whose top may have an apex.
      unsigned int
      n_cells_across(const double length,
                     const double left,
                     const double right) const
      {
        return std::max(n_cells_along(length),
                        section.has_apex_between(left, right) ? 2u : 1u);
      }

      void
      add_fall_region(const int          left_lip,
                      const int          right_lip,
                      const int          outlet,
                      const unsigned int n_columns)
      {
        const double d            = section.parameters.fall_region_depth;
        const int    left_bottom  = section.point(section.outlet_left, -d);
        const int    right_bottom = section.point(section.outlet_right, -d);
        const int    left =
          section.left_line(left_lip, left_bottom, BoundaryRole::fall_side);
        const int right =
          section.line(right_bottom, right_lip, BoundaryRole::fall_side);
        const int bottom =
          section.line(left_bottom, right_bottom, BoundaryRole::fall_bottom);
        add_block(section,
                  {{bottom}, {right}, {-outlet}, {left}},
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
        const double outlet_width = section.outlet_right - section.outlet_left;
        const double width        = section.right_end - section.left_end;
        const unsigned int n_width =
          std::max(n_cells_along(outlet_width),
                   n_cells_across((width + outlet_width) / 2.,
                                  section.left_end,
                                  section.right_end));
        if (wall_is_low())
          add_one_block(left_lip, right_lip, outlet, n_width);
        else
          add_two_blocks(left_lip, right_lip, outlet, n_width);
        return n_width;
      }

      /// Of the longer of the hopper's walls; the axis is shorter than either.
      double
      hopper_length() const
      {
        return std::max(std::hypot(e, section.right_end - section.outlet_right),
                        std::hypot(e, section.left_end - section.outlet_left));
      }

      /// Height of the material at the vertical wall.
      double
      filled_wall_height() const
      {
        return filling.right[1] == section.parameters.silo_height() ?
                 section.parameters.wall_height :
                 filling.right[1] - e;
      }

      void
      add_two_blocks(const int          left_lip,
                     const int          right_lip,
                     const int          outlet,
                     const unsigned int n_width)
      {
        const int left_top = section.point(section.left_end, filling.left[1]);
        const int wall_top = section.point(section.right_end, filling.right[1]);
        const int wall_foot = section.point(section.right_end, e);
        const int left_foot = section.point(section.left_end, e);
        const bool has_wall = left_foot != left_top;
        const int  transition =
          has_wall ? section.inner_line(left_foot, wall_foot) :
                      section.line(left_foot, wall_foot, BoundaryRole::top);
        const int left =
          section.left_line(left_foot, left_lip, BoundaryRole::hopper);
        const int right =
          section.line(right_lip, wall_foot, BoundaryRole::hopper);
        add_block(section,
                  {{outlet}, {right}, {-transition}, {left}},
                  n_width,
                  n_cells_along(hopper_length()),
                  material_group);
        if (!has_wall)
          return;
        const int left_wall =
          section.left_line(left_top, left_foot, BoundaryRole::wall);
        const Lines  top    = top_of_block(wall_top, left_top, n_width);
        const double middle = filling.line.height(dealii::Point<2>());
        const double height = section.parameters.surface_slope > 0. ?
                                (filled_wall_height() + middle - e) / 2. :
                                filled_wall_height();
        const int    right_wall =
          section.line(wall_foot, wall_top, BoundaryRole::wall);
        add_block(section,
                  {{transition}, {right_wall}, top, {left_wall}},
                  n_width,
                  n_cells_along(height),
                  material_group);
      }

      /// Material that hardly reaches above the hopper.
      void
      add_one_block(const int          left_lip,
                    const int          right_lip,
                    const int          outlet,
                    const unsigned int n_width)
      {
        const int right_end = section.point(filling.right[0], filling.right[1]);
        const int left_end  = section.point(filling.left[0], filling.left[1]);
        const Lines right =
          lines_to_end(right_lip, right_end, section.right_end);
        const Lines left =
          section.is_half ?
            Lines{section.line(left_end, left_lip, BoundaryRole::axis)} :
            reversed(lines_to_end(left_lip, left_end, section.left_end));
        const Lines        top = top_of_block(right_end, left_end, n_width);
        const unsigned int n_height = n_cells_along(
          (length_of(section, right) + length_of(section, left)) / 2.);
        add_block(section,
                  {{outlet}, right, top, left},
                  n_width,
                  std::max<unsigned int>(n_height,
                                         std::max(right.size(), left.size())),
                  material_group);
      }

      /// A block above the outlet, one beside it on each floor or shallow
      /// hopper's wall; returns how many cells wide the outlet is.
      unsigned int
      add_columns(const int left_lip, const int right_lip, const int outlet)
      {
        const double x_left  = section.outlet_left,
                     x_right = section.outlet_right;
        const unsigned int n_outlet =
          n_cells_across(x_right - x_left, x_left, x_right);
        // Above the outlet's ends.
        const int          left_top  = section.surface_point(x_left);
        const int          right_top = section.surface_point(x_right);
        const unsigned int n_height  = n_cells_along(
          (filled_wall_height() + section.place_of(right_top)[1]) / 2.);
        const int wall_foot = section.point(section.right_end, e);
        const int left_foot = section.point(section.left_end, e);
        const int right =
          right_lip == wall_foot ?
            section.line(right_lip, right_top, BoundaryRole::wall) :
            section.inner_line(right_lip, right_top);
        const int left =
          section.is_half ?
            section.line(left_top, left_lip, BoundaryRole::axis) :
          left_lip == left_foot ?
            section.line(left_top, left_lip, BoundaryRole::wall) :
            section.inner_line(left_top, left_lip);
        add_block(section,
                  {{outlet},
                   {right},
                   top_of_block(right_top, left_top, n_outlet),
                   {left}},
                  n_outlet,
                  n_height,
                  material_group);
        if (right_lip != wall_foot)
          add_right_column(right_lip, right_top, right, n_height);
        if (!section.is_half && left_lip != left_foot)
          add_left_column(left_lip, left_top, left, n_height);
        return n_outlet;
      }

      void
      add_right_column(const int          lip,
                       const int          lip_top,
                       const int          inner,
                       const unsigned int n_height)
      {
        const double       x = section.outlet_right, end = section.right_end;
        const int          wall_foot = section.point(end, e);
        const int          wall_top  = section.surface_point(end);
        const unsigned int n   = n_cells_across(std::hypot(e, end - x), x, end);
        const Lines        top = top_of_block(wall_top, lip_top, n);
        const int wall = section.line(wall_foot, wall_top, BoundaryRole::wall);
        const int bottom = section.line(lip, wall_foot, section.bottom_role);
        add_block(section,
                  {{bottom}, {wall}, top, {-inner}},
                  n,
                  n_height,
                  material_group);
      }

      void
      add_left_column(const int          lip,
                      const int          lip_top,
                      const int          inner,
                      const unsigned int n_height)
      {
        const double       x = section.outlet_left, end = section.left_end;
        const int          wall_foot = section.point(end, e);
        const int          wall_top  = section.surface_point(end);
        const unsigned int n = n_cells_across(std::hypot(e, x - end), end, x);
        const int wall  = section.line(wall_top, wall_foot, BoundaryRole::wall);
        const Lines top = top_of_block(lip_top, wall_top, n);
        const int   bottom = section.line(wall_foot, lip, section.bottom_role);
        add_block(section,
                  {{bottom}, {-inner}, top, {wall}},
                  n,
                  n_height,
                  material_group);
      }

      /// Lines from an end of the outlet up to where the surface meets the
      /// hopper or the wall.
      Lines
      lines_to_end(const int lip, const int end, const double x)
      {
        const int foot = section.point(x, e);
        if (end == foot || section.place_of(end)[1] < e)
          return {section.line(lip, end, BoundaryRole::hopper)};
        return {section.line(lip, foot, BoundaryRole::hopper),
                section.line(foot, end, BoundaryRole::wall)};
      }

      SectionGeometry      &section;
      const SectionSurface &filling;
      const double          e; ///< y of the walls' feet, in m
      std::vector<BlockTop> tops;
    };
  } // namespace



  void
  add_blocks(SectionGeometry &section)
  {
    SectionBlocks(section).add();
  }
} // namespace Sandglass
