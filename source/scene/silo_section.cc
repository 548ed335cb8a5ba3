#include <sandglass/scene/section_parts.h>
#include <sandglass/scene/silo_section.h>

#include <gmsh.h>

namespace Sandglass
{
  void
  add_silo_section(const SceneParameters &parameters,
                   const SectionSurface  &filling)
  {
    gmsh::model::add("silo");
    SectionGeometry section(parameters, filling);
    if (parameters.cell_type == CellType::triangle)
      add_outlines(section);
    else
      add_blocks(section);
    section.name_groups();
  }
} // namespace Sandglass
