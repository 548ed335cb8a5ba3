#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/newton_solver.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Sandglass
{
  namespace
  {
    /// Contact is updated when the forces are this close to balance: before,
    /// the reactions' signs say little.
    constexpr double residual_for_contact = 1e-6;

    /// The same in motion, where nodes leave and touch walls all the time.
    constexpr double moving_residual_for_contact = 1e-5;

    /// A step may raise the residual by this share. Separated material that
    /// falls doesn't change it until it meets something.
    constexpr double tolerated_rise = 1e-3;



    /**
     * How much elastic stiffness Newton's tangent gets: none as long as the
     * exact tangent serves, more after each failure, less after success. It
     * falls step by step: where the exact tangent has failed, it soon fails
     * again.
     */
    class ElasticShare
    {
    public:
      double
      value() const
      {
        return share;
      }

      /// @param factor  that the line search found; 0 is a failure.
      void
      adapt(const double factor)
      {
        if (factor == 0.)
          share = share == 0. ? first : std::min(1., share * 4.);
        else if (factor < 0.5)
          share = std::max(share, first);
        else
          share = share <= smallest ? 0. : share / 2.;
      }

    private:
      static constexpr double first    = 1e-2;
      static constexpr double smallest = 1e-3;
      double                  share    = 0.;
    };



    /// Whether the iterations run in circles: for some time the residual has
    /// not fallen by much.
    class Stall
    {
    public:
      explicit Stall(const unsigned int patience)
        : patience(patience)
      {}

      bool
      is_seen(const double norm)
      {
        if (norm < 0.5 * lowest)
          {
            lowest  = norm;
            n_since = 0;
            return false;
          }
        return ++n_since > patience;
      }

    private:
      const unsigned int patience;
      double             lowest  = std::numeric_limits<double>::max();
      unsigned int       n_since = 0;
    };



    /// How well a step has to solve the linear equations. Convergence stays
    /// faster than linear, and no more is solved for than a step can gain, or
    /// than the state at rest needs.
    double
    linear_tolerance(const double residual_norm, const double residual_at_rest)
    {
      return std::min(0.1,
                      std::max(std::sqrt(residual_norm),
                               0.3 * residual_at_rest / residual_norm));
    }



    /// Whether factors take less time than multigrid; in space they fill up
    /// sooner.
    template <int dim>
    bool
    is_solved_directly(const types::global_dof_index n_unknowns,
                       const StaticStageParameters  &parameters)
    {
      constexpr unsigned int fill = dim == 2 ? 1 : 8;
      return n_unknowns <= parameters.most_direct_unknowns / fill;
    }
  } // namespace



  template <int dim>
  NewtonSolver<dim>::NewtonSolver(const ElementGrid<dim>      &grid,
                                  Equilibrium<dim>            &equilibrium,
                                  NodeConstraints<dim>        &contact,
                                  const StaticStageParameters &parameters,
                                  NewmarkInertia<dim>         *inertia,
                                  const double relative_residual)
    : relative_residual(relative_residual > 0. ? relative_residual :
                                                 parameters.relative_residual)
    , keeps_factors(inertia == nullptr)
    , out_of_balance(grid, equilibrium, contact, inertia)
    , tangent(grid,
              is_solved_directly<dim>(grid.dof_handler.n_dofs(), parameters) ?
                TangentStorage::columns :
                TangentStorage::rows)
    , tangent_solver(tangent, make_preconditioner(grid, tangent))
    , step(grid.make_vector())
    , trial(grid.make_vector())
  {}



  template <int dim>
  void
  NewtonSolver<dim>::move(const Vector &increment,
                          const double  factor,
                          Vector       &result) const
  {
    result.zero_out_ghost_values();
    result.equ(1., increment);
    result.add(-factor, step);
    result.update_ghost_values();
  }



  template <int dim>
  bool
  NewtonSolver<dim>::find_step(const double elastic_share,
                               const double residual_norm)
  {
    out_of_balance.assemble_tangent(elastic_share, tangent);
    return tangent_solver.solve(out_of_balance.residual(),
                                linear_tolerance(residual_norm,
                                                 relative_residual),
                                step);
  }



  template <int dim>
  double
  NewtonSolver<dim>::follow_step(Vector &increment, const double factor)
  {
    move(increment, factor, trial);
    increment.swap(trial);
    return out_of_balance.evaluate(increment);
  }



  template <int dim>
  double
  NewtonSolver<dim>::search_line(Vector &increment, double &residual_norm)
  {
    double best_factor = 0., last_factor = 0.;
    double best_norm = (1. + tolerated_rise) * residual_norm;
    for (double factor = 1.; factor >= 1. / 32.; factor /= 2.)
      {
        move(increment, factor, trial);
        const double norm = out_of_balance.evaluate(trial);
        last_factor       = factor;
        if (norm < best_norm)
          {
            best_norm   = norm;
            best_factor = factor;
          }
        else if (best_factor > 0.)
          break;
        if (norm < (1. - 0.5 * factor) * residual_norm)
          break;
      }
    if (best_factor == last_factor)
      {
        increment.swap(trial);
        residual_norm = best_norm;
      }
    else
      residual_norm = follow_step(increment, best_factor);
    return best_factor;
  }



  template <int dim>
  NewtonResult
  NewtonSolver<dim>::solve(const Vector       &displacement_before,
                           const double        load_share,
                           const NewtonLimits &limits,
                           Vector             &increment)
  {
    out_of_balance.start_step(displacement_before, load_share);
    if (!keeps_factors)
      tangent_solver.forget();
    const unsigned int n_before = tangent_solver.n_iterations();
    Result             result   = iterate(limits, increment);
    result.n_linear_iterations  = tangent_solver.n_iterations() - n_before;
    return result;
  }



  template <int dim>
  NewtonResult
  NewtonSolver<dim>::iterate(const NewtonLimits &limits, Vector &increment)
  {
    ElasticShare elastic_share;
    Stall        stall(limits.patience);
    double       norm = out_of_balance.evaluate(increment);
    for (unsigned int i = 0;; ++i)
      {
        if (norm < (keeps_factors ? residual_for_contact :
                                    moving_residual_for_contact))
          {
            if (out_of_balance.update_contact() > 0)
              norm = out_of_balance.evaluate(increment);
            else if (norm < relative_residual)
              return {true, i, 0, norm};
          }

        if (i == limits.most_iterations || !std::isfinite(norm) ||
            stall.is_seen(norm) || !find_step(elastic_share.value(), norm))
          return {false, i, 0, norm};

        const double factor = search_line(increment, norm);
        // The elastic step is the last resort: follow it even uphill.
        if (factor == 0. && elastic_share.value() == 1.)
          norm = follow_step(increment, 0.5);
        else
          elastic_share.adapt(factor);
      }
  }



#define INSTANTIATE(dim) template class NewtonSolver<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
