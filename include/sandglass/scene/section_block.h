#ifndef sandglass_scene_section_block_h
#define sandglass_scene_section_block_h

#include <sandglass/scene/section_geometry.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// Lines of SectionGeometry, each of which starts where the last one ends.
  using SectionLines = std::vector<int>;

  SectionLines
  reversed(const SectionLines &lines);

  double
  length_of(const SectionGeometry &section, const SectionLines &lines);

  /// How many cells of a section's size a length holds, at least one.
  unsigned int
  n_cells_along(const SectionGeometry &section, const double length);

  /// The sides of a block, counterclockwise.
  struct BlockSides
  {
    SectionLines bottom, right, top, left;
  };

  /// Add a surface of n x m quadrilaterals, with as many edges on its sides as
  /// these have lines, or more.
  void
  add_block(SectionGeometry   &section,
            const BlockSides  &sides,
            const unsigned int n,
            const unsigned int m,
            const std::string &name);

  /// The top of a block of material.
  struct BlockTop
  {
    SectionLines lines;       ///< from right to left
    int          right, left; ///< points
    unsigned int n;           ///< cells
  };

  /// Add on each block of material an empty one up to the silo's top.
  void
  add_space_blocks(SectionGeometry &section, const std::vector<BlockTop> &tops);
} // namespace Sandglass

#endif
