#ifndef sandglass_flow_updated_lagrangian_tangent_preconditioner_h
#define sandglass_flow_updated_lagrangian_tangent_preconditioner_h

#include <deal.II/lac/trilinos_precondition.h>

#include <sandglass/flow/updated_lagrangian/tangent_matrix.h>

#include <Amesos_BaseSolver.h>
#include <Epetra_LinearProblem.h>

#include <memory>

namespace Sandglass
{
  /// An inverse of a tangent, or nearly so, that serves later tangents too.
  template <int dim>
  class TangentPreconditioner
  {
  public:
    using Vector = DisplacementVector;

    /**
     * @param update_cost      what update() takes, in iterations.
     * @param most_iterations  after which the solution is not worth going on.
     */
    TangentPreconditioner(const unsigned int update_cost,
                          const unsigned int most_iterations)
      : update_cost(update_cost)
      , most_iterations(most_iterations)
    {}

    virtual ~TangentPreconditioner() = default;

    /// Take the tangent as it is now; false if it is singular. Collective.
    /// Throws where Trilinos can't work with it at all.
    virtual bool
    update() = 0;

    /// Multiply by the inverse of the tangent that update() has taken.
    virtual void
    vmult(DisplacementVector       &solution,
          const DisplacementVector &right_side) = 0;

    const unsigned int update_cost, most_iterations;
  };



  /**
   * The factors of Trilinos' direct solver KLU, by Amesos, which gathers the
   * matrix on the first rank. The order of elimination is found once, and the
   * pivots serve again as long as the result is well conditioned. deal.II's
   * interface to Amesos would begin from nothing each time.
   */
  template <int dim>
  class TangentFactors : public TangentPreconditioner<dim>
  {
  public:
    /// @param tangent  stored by columns.
    explicit TangentFactors(const TangentMatrix<dim> &tangent);

    bool
    update() override;

    void
    vmult(DisplacementVector       &solution,
          const DisplacementVector &right_side) override;

  private:
    const Epetra_CrsMatrix            &matrix;
    Epetra_LinearProblem               problem;
    std::unique_ptr<Amesos_BaseSolver> factors;
  };



  /**
   * A cycle of algebraic multigrid by smoothed aggregation, of Trilinos' ML. It
   * divides memory and work among the ranks, and both grow no faster than the
   * number of unknowns.
   */
  template <int dim>
  class TangentMultigrid : public TangentPreconditioner<dim>
  {
  public:
    /// @param tangent  stored by rows.
    TangentMultigrid(const ElementGrid<dim>   &grid,
                     const TangentMatrix<dim> &tangent);

    bool
    update() override;

    void
    vmult(DisplacementVector       &solution,
          const DisplacementVector &right_side) override;

  private:
    static constexpr unsigned int n_rigid_modes = dim * (dim + 1) / 2;

    /// Of the undeformed body: translations, then rotations. Without these
    /// multigrid takes several times as many iterations in space.
    void
    find_rigid_modes(const ElementGrid<dim> &grid);

    const TangentMatrix<dim>                         &tangent;
    TrilinosWrappers::PreconditionAMG::AdditionalData settings;
    TrilinosWrappers::PreconditionAMG                 multigrid;
    /// In space, one after the other, of the degrees of freedom that this rank
    /// owns.
    std::vector<double> rigid_modes;
  };



  /// What fits the tangent's storage: factors for columns, multigrid for rows.
  template <int dim>
  std::unique_ptr<TangentPreconditioner<dim>>
  make_preconditioner(const ElementGrid<dim>   &grid,
                      const TangentMatrix<dim> &tangent);
} // namespace Sandglass

#endif
