#ifndef sandglass_scene_section_surface_nodes_h
#define sandglass_scene_section_surface_nodes_h

#include <sandglass/scene/mesh.h>

#include <functional>
#include <set>

namespace Sandglass
{
  /**
   * Move nodes of a section onto a line y(x) that they are close to: those on
   * the boundary along it, unless it has a corner there. Nodes within a few
   * cells follow as long as that makes the worst of the cells around them
   * better, so that the line's own nodes get on; cells keep a good shape, and
   * a node stays short of the line where they could not.
   *
   * @param height  of the line, in m.
   */
  void
  move_surface_nodes(Mesh<2>                             &mesh,
                     const std::set<unsigned int>        &nodes,
                     const std::function<double(double)> &height);
} // namespace Sandglass

#endif
