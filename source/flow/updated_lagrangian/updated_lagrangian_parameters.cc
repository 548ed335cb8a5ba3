#include <sandglass/base/parameter_entries.h>
#include <sandglass/flow/updated_lagrangian/updated_lagrangian_parameters.h>

namespace Sandglass
{
  UpdatedLagrangianParameters::UpdatedLagrangianParameters()
    : ParameterAcceptor("Updated Lagrangian stage")
  {
    using Bounds = BoundedNumber;

    add_number(*this,
               "Time step",
               time_step,
               Bounds::greater_than(0.),
               "s",
               "The longest one; steps that have no solution are halved, and "
               "grow again.");
    add_number(*this,
               "Newmark delta",
               newmark.delta,
               Bounds::within(0.5, 1.),
               "1",
               "How far the acceleration at a step's end decides its velocity: "
               "1/2 (paper) is of second order and damps nothing, more damps.");
    add_number(*this,
               "Newmark alpha",
               newmark.alpha,
               Bounds::within(0.25, 1.),
               "1",
               "The same of its displacement; with 1/4 (paper) beside a delta "
               "of 1/2 linear motions keep their energy.");
    add_integer(*this,
                "Element order",
                element_order,
                1,
                2,
                "2: triangles with six nodes (paper); 1: with three, which "
                "lock.");
    add_number(*this,
               "Relative residual",
               relative_residual,
               Bounds::between(0., 1.),
               "1",
               "Newton stops when the out-of-balance force is below this share "
               "of the weight, or of larger forces.");
  }
} // namespace Sandglass
