#ifndef sandglass_flow_updated_lagrangian_motion_moving_grid_h
#define sandglass_flow_updated_lagrangian_motion_moving_grid_h

#include <sandglass/flow/updated_lagrangian/element_grid.h>
#include <sandglass/flow/updated_lagrangian/rezoning/field.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <vector>

namespace Sandglass
{
  /**
   * A TriangleMesh as finite elements, on this rank alone. The elements' grid
   * has straight edges; what nodes in the middle of curved ones differ from it
   * is a displacement that strains nothing (see Equilibrium::move_reference()).
   */
  class MovingGrid
  {
  public:
    using Vector = DisplacementVector;

    explicit MovingGrid(const TriangleMesh &mesh);

    /// From straight edges to the mesh, with ghost entries.
    const Vector &
    bulge() const
    {
      return bulge_of_edges;
    }

    /// The mesh after a displacement from straight edges.
    TriangleMesh
    displaced(const Vector &displacement) const;

    /// A field of two components at the mesh's nodes, with ghost entries.
    Vector
    vector_of(const MeshField &field) const;

    /// The same back.
    MeshField
    field_of(const Vector &vector) const;

    const TriangleMesh   mesh;
    const ElementGrid<2> elements;

    /// First degree of freedom of each of the mesh's nodes.
    std::vector<unsigned int> dof_of_node;
    /// Where each node is on straight edges, in m.
    std::vector<Point<2>> straight;

  private:
    Vector bulge_of_edges;
  };
} // namespace Sandglass

#endif
