#ifndef sandglass_flow_dynamic_flow_h
#define sandglass_flow_dynamic_flow_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <sandglass/continuum/symmetric_components.h>
#include <sandglass/flow/flow.h>
#include <sandglass/walls/wall_force.h>

#include <functional>
#include <vector>

namespace Sandglass
{
  /// What material starts from at a point, beside being at rest.
  template <int dim>
  struct InitialState
  {
    Tensor<1, dim>               displacement; ///< in m
    SymmetricComponents<2 * dim> stress;       ///< in Pa
    double                       volume_ratio; ///< current over unstressed
    /// See StateVariable; none: the law's own.
    std::vector<double> law_state = {};
  };

  /// For a cell of the scene and a reference point in it.
  template <int dim>
  using InitialStateFunction =
    std::function<InitialState<dim>(const unsigned int cell,
                                    const Point<dim>  &reference_point)>;

  /// How DynamicFlow::settle() has ended.
  struct Settling
  {
    unsigned int n_steps       = 0;
    double       largest_speed = 0.; ///< in m/s
  };

  /// A flow in time that may start from a state at rest.
  template <int dim>
  class DynamicFlow : public Flow
  {
  public:
    /**
     * Give the material its state, and the walls the forces that hold it.
     * Collective.
     *
     * @param wall_forces  of the state at rest, each node's on any rank.
     */
    virtual void
    start_from(const InitialStateFunction<dim>   &initial_state,
               const std::vector<WallForce<dim>> &wall_forces) = 0;

    /**
     * Let material that can't leave find its place where it is in equilibrium
     * in this flow's own equations: the state that it has started from may be
     * one of other equations. The clock and all sums over time start anew.
     * Collective.
     */
    virtual Settling
    settle() = 0;

    /// Sum what walls do from now on: walls have come or gone.
    virtual void
    start_wall_records_anew() = 0;
  };
} // namespace Sandglass

#endif
