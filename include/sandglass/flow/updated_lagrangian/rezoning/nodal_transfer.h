#ifndef sandglass_flow_updated_lagrangian_rezoning_nodal_transfer_h
#define sandglass_flow_updated_lagrangian_rezoning_nodal_transfer_h

#include <sandglass/flow/updated_lagrangian/rezoning/field.h>
#include <sandglass/flow/updated_lagrangian/rezoning/point_locator.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <vector>

namespace Sandglass
{
  /// Where the nodes of a new mesh lie in the old one, each in the body of the
  /// same number. A node belongs to one body.
  std::vector<Location>
  locate_nodes(const PointLocator &locator, const TriangleMesh &new_mesh);

  /**
   * Values of a field at these places: the old mesh's shape functions there.
   *
   * Where the old cells' edges are straight, polynomials of the element's order
   * are kept to rounding, and linear ones everywhere.
   */
  MeshField
  transfer_nodal_field(const TriangleMesh          &old_mesh,
                       const MeshField             &field,
                       const std::vector<Location> &locations);
} // namespace Sandglass

#endif
