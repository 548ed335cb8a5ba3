#ifndef sandglass_walls_section_tangent_h
#define sandglass_walls_section_tangent_h

#include <deal.II/base/tensor.h>

#include <cmath>

namespace Sandglass
{
  /**
   * Unit tangent of a wall in a section, for results that show tangential
   * forces with a sign: the normal turned by 90 degrees so that it points up,
   * or along +x on a horizontal wall.
   */
  inline dealii::Tensor<1, 2>
  wall_tangent(const dealii::Tensor<1, 2> &normal)
  {
    dealii::Tensor<1, 2> tangent{{-normal[1], normal[0]}};
    const bool           points_down = tangent[1] < -1e-12;
    const bool points_left = std::abs(tangent[1]) <= 1e-12 && tangent[0] < 0.;
    return points_down || points_left ? -1. * tangent : tangent;
  }
} // namespace Sandglass

#endif
