#ifndef sandglass_static_stage_equilibrium_h
#define sandglass_static_stage_equilibrium_h

#include <deal.II/fe/fe_values.h>

#include <sandglass/material/drucker_prager.h>
#include <sandglass/static_stage/filled_grid.h>
#include <sandglass/static_stage/gradient_operator.h>
#include <sandglass/static_stage/tangent_matrix.h>
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

    /// Make the state of the last evaluate_forces() the start of a load step.
    void
    start_step();

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
    assemble_tangent(const WallContact &contact,
                     const double       elastic_share,
                     TangentMatrix     &matrix) const;

    /// Quadrature point q of active cell i has the index i * n_points + q. Only
    /// those of FilledGrid::local_cells mean anything.
    const std::vector<MaterialPoint> &
    material_points() const
    {
      return points;
    }

  private:
    /// Add to the values at those of the cell's nodes that this rank owns.
    void
    add_to(const FilledGrid::LocalCell            &local_cell,
           const Eigen::Ref<const Eigen::VectorXd> values,
           Vector                                 &vector) const;

    /// Weight and unloaded configuration.
    void
    set_up(const Formulation formulation,
           const double      density,
           const BodyForce  &body_force);

    void
    set_up_point(const FEValues<dim> &fe_values,
                 const unsigned int   q,
                 const Formulation    formulation,
                 const unsigned int   index);

    /// Make the deformed configuration the reference of one point.
    void
    start_step(const unsigned int index);

    template <int n_dofs>
    void
    update_stress(const Eigen::Matrix<double, n_dofs, 1> &increment,
                  const unsigned int                      index);

    /// @tparam n_dofs  per cell; known to the compiler, it saves a fifth of the
    ///                 time.
    template <int n_dofs>
    void
    add_internal_forces(const Vector &increment, Vector &forces);

    template <int n_dofs>
    Eigen::Matrix<double, n_dofs, n_dofs>
    cell_tangent(const CellAccessor<dim> &cell,
                 const WallContact       &contact,
                 const double             elastic_share) const;

    template <int n_dofs>
    void
    add_cell_tangents(const WallContact &contact,
                      const double       elastic_share,
                      TangentMatrix     &matrix) const;

    const FilledGrid    &grid;
    const DruckerPrager &material;

    std::vector<MaterialPoint>    points;
    std::vector<GradientOperator> gradient_operators;
    /// In the reference configuration, in m^3 (plane strain: per m of depth).
    std::vector<double> volumes;
    Vector              nodal_weight;
  };
} // namespace Sandglass

#endif
