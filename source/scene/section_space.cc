#include <sandglass/scene/section_block.h>
#include <sandglass/scene/silo_section.h>

#include <algorithm>
#include <map>

namespace Sandglass
{
  namespace
  {
    /// The lines from points of the material's surface up to the silo's top.
    class LinesToTop
    {
    public:
      explicit LinesToTop(SectionGeometry &section)
        : section(section)
        , filling(section.filling)
      {}

      /// Neighbouring blocks share those between them.
      const SectionLines &
      operator()(const int start)
      {
        const auto [entry, is_new] = known.emplace(start, SectionLines());
        if (is_new)
          entry->second = lines_from(start);
        return entry->second;
      }

    private:
      SectionLines
      lines_from(const int start)
      {
        if (start == section.point(filling.right[0], filling.right[1]))
          return along_wall(start, section.right_end);
        const int    left = section.point(filling.left[0], filling.left[1]);
        const double x    = section.place_of(start)[0];
        if (start == left && !section.is_half)
          return along_wall(start, section.left_end);
        const int end = section.point(x, filling.top);
        return {start == left ? section.line(start, end, BoundaryRole::axis) :
                                section.inner_line(start, end)};
      }

      SectionLines
      along_wall(const int start, const double x)
      {
        const double e    = section.parameters.hopper_height;
        const int    foot = section.point(x, e);
        const int    end  = section.point(x, filling.top);
        if (start == foot || section.place_of(start)[1] > e)
          return {section.line(start, end, BoundaryRole::wall)};
        SectionLines lines = {section.line(start, foot, BoundaryRole::hopper)};
        if (foot != end)
          lines.push_back(section.line(foot, end, BoundaryRole::wall));
        return lines;
      }

      SectionGeometry            &section;
      const SectionSurface       &filling;
      std::map<int, SectionLines> known; ///< by where they start
    };
  } // namespace



  void
  add_space_blocks(SectionGeometry &section, const std::vector<BlockTop> &tops)
  {
    const SectionSurface &filling = section.filling;
    const double          apex    = filling.line.height(dealii::Point<2>());
    const double          height = filling.top - (apex + filling.right[1]) / 2.;
    LinesToTop            lines_to_top(section);
    // Hopper and wall together have two lines.
    unsigned int n_height = n_cells_along(section, height);
    for (const BlockTop &top : tops)
      for (const int end : {top.right, top.left})
        n_height = std::max<unsigned int>(n_height, lines_to_top(end).size());
    for (const BlockTop &top : tops)
      {
        const SectionLines right = lines_to_top(top.right);
        const SectionLines left  = lines_to_top(top.left);
        const int          line  = section.line(section.end_of(right.back()),
                                      section.end_of(left.back()),
                                      BoundaryRole::top);
        add_block(section,
                  {reversed(top.lines), right, {line}, reversed(left)},
                  top.n,
                  n_height,
                  space_group);
      }
  }
} // namespace Sandglass
