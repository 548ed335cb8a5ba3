#ifndef sandglass_flow_updated_lagrangian_equilibrium_h
#define sandglass_flow_updated_lagrangian_equilibrium_h

#include <sandglass/continuum/symmetric_components.h>
#include <sandglass/flow/updated_lagrangian/filled_grid.h>
#include <sandglass/flow/updated_lagrangian/tangent_matrix.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>
#include <sandglass/material/material_parameters.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <functional>
#include <memory>
#include <vector>

namespace Sandglass
{
  /**
   * Nodal forces of the filled material and their tangent, in the updated
   * Lagrangian formulation: the configuration at the start of the load step is
   * the reference for the step's increment of displacement. Whatever the
   * kinematics and the law, see MaterialEquilibrium.
   */
  template <int dim>
  class Equilibrium
  {
  public:
    using Vector = DisplacementVector;

    /// Force per mass, in m/s^2, at a point of the unloaded material.
    using BodyForce = std::function<Tensor<1, dim>(const Point<dim> &)>;

    virtual ~Equilibrium() = default;

    /// Nodal forces of the whole weight in N, with ghost entries. Mass is
    /// conserved: they don't change as the material deforms.
    const Vector &
    weight() const
    {
      return nodal_weight;
    }

    /// Make the state of the last evaluate_forces() the start of a load step.
    virtual void
    start_step() = 0;

    /**
     * Internal minus external nodal forces, in N, with ghost entries.
     *
     * @param increment   of the displacement in the step, with ghost entries.
     * @param load_share  share of gravity that acts.
     */
    virtual void
    evaluate_forces(const Vector &increment,
                    const double  load_share,
                    Vector       &forces) = 0;

    /**
     * Tangent of the equations with contact, at the last evaluate_forces().
     *
     * @param elastic_share  from 0, the law's exact tangent, to 1, the elastic
     *                       stiffness.
     */
    virtual void
    assemble_tangent(const WallContact<dim> &contact,
                     const double            elastic_share,
                     TangentMatrix<dim>     &matrix) const = 0;

    /// What is known at a quadrature point.
    struct PointState
    {
      SymmetricComponents<2 * dim> stress;       ///< in Pa
      double                       volume_ratio; ///< current over unloaded
      std::vector<double>          law_state;    ///< see StateVariable
    };

    /// @param index  see FilledGrid::point_index(); of FilledGrid::local_cells.
    virtual PointState
    point_state(const unsigned int index) const = 0;

    /// Write the state at the start of a load step; complete on rank 0.
    /// Collective.
    virtual void
    save(boost::archive::binary_oarchive &archive) const = 0;

    /// Go back to what save() has written, on any number of ranks.
    virtual void
    load(boost::archive::binary_iarchive &archive) = 0;

    /// Modulus in Pa of uniaxial strain that no state of the law exceeds.
    virtual double
    confined_modulus() const = 0;

    /// Whether material without stress is as stiff as any.
    virtual bool
    has_constant_stiffness() const = 0;

  protected:
    explicit Equilibrium(const FilledGrid<dim> &grid)
      : nodal_weight(grid.make_vector())
    {}

    Vector nodal_weight;
  };



  /// For the law that the parameters name. Throws InputError.
  template <int dim>
  std::unique_ptr<Equilibrium<dim>>
  make_equilibrium(const FilledGrid<dim>    &grid,
                   const Formulation         formulation,
                   const MaterialParameters &material,
                   const Tensor<1, dim>     &gravity);
} // namespace Sandglass

#endif
