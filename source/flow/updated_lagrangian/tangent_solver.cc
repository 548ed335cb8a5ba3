#include <deal.II/base/mpi.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/tangent_solver.h>

#include <cmath>
#include <numeric>
#include <utility>

namespace Sandglass
{
  namespace
  {
    /// After so many directions the method forgets them, and begins anew.
    constexpr unsigned int most_improvements = 40;
  } // namespace



  template <int dim>
  TangentSolver<dim>::TangentSolver(
    const TangentMatrix<dim>                   &tangent,
    std::unique_ptr<TangentPreconditioner<dim>> preconditioner)
    : tangent(tangent)
    , preconditioner(std::move(preconditioner))
  {}



  template <int dim>
  bool
  TangentSolver<dim>::solve(const Vector &right_side,
                            const double  tolerance,
                            Vector       &solution)
  {
    // The preconditioner ages. An update is due when the last solution took
    // more iterations than one does on average, the update's cost shared out.
    const bool is_due = last_iterations * n_solutions >
                        preconditioner->update_cost + n_their_iterations;
    if (is_updated && !is_due && iterate(right_side, tolerance, solution))
      return true;
    return update() && iterate(right_side, tolerance, solution);
  }



  template <int dim>
  bool
  TangentSolver<dim>::iterate(const Vector &right_side,
                              const double  tolerance,
                              Vector       &solution)
  {
    solution.zero_out_ghost_values();
    solution            = 0.;
    residual            = right_side;
    const double target = tolerance * right_side.l2_norm();
    unsigned int n      = 0;
    for (; !(residual.l2_norm() <= target); ++n, ++n_all_iterations)
      if (n == preconditioner->most_iterations ||
          !improve(n % most_improvements, solution))
        return false;
    last_iterations = n;
    n_their_iterations += n;
    ++n_solutions;
    return true;
  }



  template <int dim>
  bool
  TangentSolver<dim>::improve(const unsigned int n, Vector &solution)
  {
    if (n == improvements.size())
      improvements.push_back({residual, residual});
    auto &[direction, image] = improvements[n];
    preconditioner->vmult(direction, residual);
    tangent.vmult(image, direction);
    // The classical Gram-Schmidt method needs one sum over the ranks, and is
    // exact enough for so few directions. The residual remains that of the
    // solution in any case.
    std::vector<double> shares(n);
    for (unsigned int i = 0; i < n; ++i)
      shares[i] = std::inner_product(image.begin(),
                                     image.end(),
                                     improvements[i].image.begin(),
                                     0.);
    Utilities::MPI::sum(shares, image.get_mpi_communicator(), shares);
    for (unsigned int i = 0; i < n; ++i)
      {
        direction.add(-shares[i], improvements[i].direction);
        image.add(-shares[i], improvements[i].image);
      }
    const double norm = image.l2_norm();
    if (!(norm > 0.) || !std::isfinite(norm))
      return false;
    direction /= norm;
    image /= norm;

    const double factor = residual * image;
    solution.add(factor, direction);
    residual.add(-factor, image);
    return true;
  }



  template <int dim>
  bool
  TangentSolver<dim>::update()
  {
    is_updated  = preconditioner->update();
    n_solutions = n_their_iterations = last_iterations = 0;
    return is_updated;
  }



#define INSTANTIATE(dim) template class TangentSolver<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
