#ifndef sandglass_flow_updated_lagrangian_rezoning_rezone_h
#define sandglass_flow_updated_lagrangian_rezoning_rezone_h

#include <deal.II/base/quadrature.h>

#include <sandglass/flow/updated_lagrangian/rezoning/body_totals.h>
#include <sandglass/flow/updated_lagrangian/rezoning/field.h>
#include <sandglass/flow/updated_lagrangian/rezoning/outlines.h>
#include <sandglass/flow/updated_lagrangian/rezoning/point_transfer.h>
#include <sandglass/flow/updated_lagrangian/rezoning/rezoning_jumps.h>
#include <sandglass/flow/updated_lagrangian/rezoning/size_field.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

namespace Sandglass
{
  /// What is known of the material on a mesh.
  struct MeshState
  {
    TriangleMesh mesh;
    /// Of the nodes, two components, in m/s.
    MeshField velocity;
    /// What else there is at nodes: acceleration, displacement.
    MeshField nodal_fields;
    /// At quadrature points, in kg/m^3.
    std::vector<double> density;
    /// What else there is at quadrature points: stress, the law's state.
    MeshField point_fields;
  };

  /// How to mesh anew, and what to keep.
  struct RezoningOptions
  {
    CornerRule    corners;
    SizeField     size;
    Quadrature<2> quadrature; ///< of the stress and of the mass matrix
    Depth         depth;
    /// See PatchRecovery.
    double margin = 0.25;
    /// Of the point fields; may be empty.
    Admissible is_admissible = {};
    /// Components of momentum that are kept, see restore_momentum().
    std::array<bool, 2> keeps_momentum = {{true, true}};
  };

  /// The material on a new mesh.
  struct Rezoned
  {
    MeshState     state;
    RezoningJumps jumps;
  };

  /**
   * Mesh the material's bodies anew within their boundaries, and map what is
   * known of them.
   *
   * Nodal fields are interpolated, fields at quadrature points recovered by
   * patches. Then each body's mass is restored by its density, and its momentum
   * by its velocity. Stress is not in equilibrium afterwards, nor does it obey
   * the yield condition. There has to be at least one body. Throws RunError
   * where one can't be meshed.
   */
  Rezoned
  rezone(const MeshState &old, const RezoningOptions &options);
} // namespace Sandglass

#endif
