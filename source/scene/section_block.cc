#include <sandglass/scene/section_block.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace Sandglass
{
  namespace
  {
    /// Let lines have n edges together, each at least one.
    void
    divide(const SectionGeometry &section,
           const SectionLines    &lines,
           const unsigned int     n)
    {
      const double whole  = length_of(section, lines);
      double       length = 0.;
      unsigned int n_used = 0;
      for (unsigned int i = 0; i < lines.size(); ++i)
        {
          length += section.length_of(lines[i]);
          const unsigned int n_others = lines.size() - 1 - i;
          const unsigned int n_up_to =
            n_others == 0 ? n :
                            std::clamp(static_cast<unsigned int>(
                                         std::round(n * length / whole)),
                                       n_used + 1,
                                       n - n_others);
          gmsh::model::geo::mesh::setTransfiniteCurve(std::abs(lines[i]),
                                                      n_up_to - n_used + 1);
          n_used = n_up_to;
        }
    }
  } // namespace



  SectionLines
  reversed(const SectionLines &lines)
  {
    SectionLines result;
    std::transform(lines.rbegin(),
                   lines.rend(),
                   std::back_inserter(result),
                   [](const int line) { return -line; });
    return result;
  }



  double
  length_of(const SectionGeometry &section, const SectionLines &lines)
  {
    return std::accumulate(lines.begin(),
                           lines.end(),
                           0.,
                           [&](const double sum, const int line) {
                             return sum + section.length_of(line);
                           });
  }



  unsigned int
  n_cells_along(const SectionGeometry &section, const double length)
  {
    return std::max(1., std::round(length / section.resolution.element_size));
  }



  void
  add_block(SectionGeometry   &section,
            const BlockSides  &sides,
            const unsigned int n,
            const unsigned int m,
            const std::string &name)
  {
    SectionLines     outline;
    std::vector<int> corners;
    for (const SectionLines *side :
         {&sides.bottom, &sides.right, &sides.top, &sides.left})
      {
        corners.push_back(section.start_of(side->front()));
        outline.insert(outline.end(), side->begin(), side->end());
      }
    const int tag = section.surface(outline, name);
    divide(section, sides.bottom, n);
    divide(section, sides.top, n);
    divide(section, sides.right, m);
    divide(section, sides.left, m);
    if (outline.size() == corners.size())
      gmsh::model::geo::mesh::setTransfiniteSurface(tag);
    else
      gmsh::model::geo::mesh::setTransfiniteSurface(tag, "Left", corners);
    gmsh::model::geo::mesh::setRecombine(2, tag);
  }
} // namespace Sandglass
