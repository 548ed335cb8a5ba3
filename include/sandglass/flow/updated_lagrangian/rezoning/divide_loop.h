#ifndef sandglass_flow_updated_lagrangian_rezoning_divide_loop_h
#define sandglass_flow_updated_lagrangian_rezoning_divide_loop_h

#include <sandglass/flow/updated_lagrangian/rezoning/boundary_piece.h>
#include <sandglass/flow/updated_lagrangian/rezoning/size_field.h>

namespace Sandglass
{
  /**
   * The boundary of a new mesh: a loop divided into pieces of the wanted
   * lengths.
   *
   * Corners are kept, and between them new nodes lie on the old boundary. The
   * middle of a new piece stands above the middle of its chord, as high that
   * the new piece and the old boundary enclose the same area, so that a loop of
   * quadratic pieces keeps its area to rounding. Where the old boundary turns
   * so strongly that the new piece would bulge by more than an eighth of its
   * chord, pieces are halved, up to three times; beyond that the bulge is cut,
   * and area lost or gained.
   *
   * @param order  1: straight pieces, of whose area nothing is said.
   */
  BoundaryLoop
  divide_loop(const BoundaryLoop &loop,
              const SizeField    &size,
              const unsigned int  order);
} // namespace Sandglass

#endif
