#ifndef sandglass_static_stage_equilibrium_h
#define sandglass_static_stage_equilibrium_h

#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <sandglass/material/drucker_prager.h>
#include <sandglass/static_stage/filled_grid.h>
#include <sandglass/static_stage/incremental_response.h>
#include <sandglass/static_stage/wall_contact.h>

#include <functional>
#include <vector>

namespace Sandglass
{
  /**
   * Nodal forces of the filled material and their tangent, in the updated
   * Lagrangian formulation: the configuration at the start of the load step is
   * the reference for the step's increment of displacement.
   */
  class Equilibrium
  {
  public:
    using Vector = FilledGrid::Vector;

    /// Force per mass, in m/s^2, at a point of the unloaded material.
    using BodyForce = std::function<Tensor<1, dim>(const Point<dim> &)>;

    /// At a quadrature point; "before" is the start of the load step.
    struct MaterialPoint
    {
      SymmetricTensor4 stress_before = SymmetricTensor4::Zero(); ///< in Pa
      SymmetricTensor4 trial_stress  = SymmetricTensor4::Zero(); ///< in Pa
      SymmetricTensor4 stress        = SymmetricTensor4::Zero(); ///< in Pa
      Gradient5        gradient      = Gradient5::Zero();        ///< H
      /// Current over unloaded volume.
      double volume_ratio_before = 1., volume_ratio = 1.;
    };

    Equilibrium(const FilledGrid     &grid,
                const Formulation     formulation,
                const DruckerPrager  &material,
                const double          density,
                const Tensor<1, dim> &gravity);

    /// Under a body force that varies in space, as manufactured solutions have.
    Equilibrium(const FilledGrid    &grid,
                const Formulation    formulation,
                const DruckerPrager &material,
                const double         density,
                const BodyForce     &body_force);

    /// Nodal forces of the whole weight in N, with ghost entries. Mass is
    /// conserved: they don't change as the material deforms.
    const Vector &
    weight() const
    {
      return nodal_weight;
    }

    /// Make the current state the start of a load step.
    void
    start_step(const Vector &displacement);

    /**
     * Internal minus external nodal forces, in N, with ghost entries.
     *
     * @param increment   of the displacement in the step, with ghost entries.
     * @param load_share  share of gravity that acts.
     */
    void
    evaluate_forces(const Vector &increment,
                    const double  load_share,
                    Vector       &forces);

    /**
     * Tangent of the equations with contact, at the last evaluate_forces().
     *
     * @param elastic_share  from 0, the exact derivative of the stress
     *                       projection, to 1, the elastic stiffness.
     */
    void
    assemble_tangent(const WallContact              &contact,
                     const double                    elastic_share,
                     TrilinosWrappers::SparseMatrix &matrix) const;

    /// Quadrature point q of active cell i has the index i * n_points + q.
    const std::vector<MaterialPoint> &
    material_points() const
    {
      return points;
    }

  private:
    /// Maps nodal increments of a cell to their gradient H at a point.
    using GradientOperator = Eigen::Matrix<double, 5, Eigen::Dynamic, 0, 5, 8>;
    using CellVector       = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 8, 1>;
    using CellMatrix =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 8, 8>;
    using CellIterator = DoFHandler<dim>::active_cell_iterator;

    /// Call `work(cell, dofs)` for each owned cell.
    template <typename Work>
    void
    for_each_cell(const Work &work) const;

    /// Make the deformed configuration the reference of one point.
    void
    start_step(const FEValues<dim> &fe_values,
               const unsigned int   q,
               const CellVector    &displacement,
               const unsigned int   index);

    void
    update_stress(const CellVector &increment, const unsigned int index);

    CellMatrix
    cell_tangent(const CellIterator &cell,
                 const WallContact  &contact,
                 const double        elastic_share) const;

    void
    assemble_weight(const double density, const BodyForce &body_force);

    const FilledGrid    &grid;
    const Formulation    formulation;
    const DruckerPrager &material;

    std::vector<MaterialPoint>    points;
    std::vector<GradientOperator> gradient_operators;
    /// In the reference configuration, in m^3 (plane strain: per m of depth).
    std::vector<double> volumes;
    Vector              nodal_weight;
  };
} // namespace Sandglass

#endif
