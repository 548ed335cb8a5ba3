#ifndef sandglass_flow_updated_lagrangian_rezoning_rezoning_criterion_h
#define sandglass_flow_updated_lagrangian_rezoning_rezoning_criterion_h

#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// What elements must not do, lest the body be meshed anew.
  struct RezoningCriterion
  {
    /// See jacobian_ratio().
    double smallest_jacobian_ratio = 0.2;
    /// In radians, see smallest_angle().
    double smallest_angle = 0.17;
    /// How deep a rigid corner may stand in the material, over the length of
    /// the boundary edge that it has cut.
    double deepest_corner = 0.02;
    /// Corners of walls that point into the material, in m: the lip.
    std::vector<Point<2>> rigid_corners = {};
  };

  /// What an element does worst.
  enum class ElementFault
  {
    jacobian,    ///< it is distorted, or has turned over
    angle,       ///< it is flat
    rigid_corner ///< a rigid corner stands in the material, through its edge
  };

  /// The element that asks most for re-zoning.
  struct WorstElement
  {
    unsigned int cell = numbers::invalid_unsigned_int;
    Point<2>     position; ///< of the element's middle, in m
    ElementFault fault = ElementFault::jacobian;
    /// Jacobian ratio, angle or depth, as in RezoningCriterion.
    double value = 0.;
    double bound = 0.; ///< that the criterion sets
    /// How far it is from the bound: below 1 the criterion is not met.
    double quality = 1e300;

    bool
    needs_rezoning() const
    {
      return quality < 1.;
    }

    /// What is wrong, for the log.
    std::string
    description() const;
  };

  WorstElement
  find_worst_element(const TriangleMesh      &mesh,
                     const RezoningCriterion &criterion);
} // namespace Sandglass

#endif
