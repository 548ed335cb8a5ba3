#ifndef sandglass_flow_updated_lagrangian_equilibrium_h
#define sandglass_flow_updated_lagrangian_equilibrium_h

#include <sandglass/continuum/formulation.h>
#include <sandglass/continuum/symmetric_components.h>
#include <sandglass/flow/updated_lagrangian/element_grid.h>
#include <sandglass/flow/updated_lagrangian/node_constraints.h>
#include <sandglass/flow/updated_lagrangian/tangent_matrix.h>
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

    /// Other nodal forces of the whole weight than those of even density, in N
    /// with ghost entries.
    void
    set_weight(const Vector &weight)
    {
      nodal_weight = weight;
    }

    /// Say that steps are those of motion, in which strain is large: strain and
    /// rotation are taken in the middle of the step, and material that is
    /// looser than it can be without stress bears none until it is compacted
    /// again, as in the particle stage.
    void
    set_large_steps()
    {
      has_large_steps = true;
    }

    /// Time in s that steps take from here on, of which laws may want to know;
    /// 0 for load steps, which are infinitely slow.
    void
    set_time_step(const double time_step)
    {
      this->time_step = time_step;
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
     * Tangent of the nodes' equations without inertia, at the last
     * evaluate_forces().
     *
     * @param elastic_share  from 0, the law's exact tangent, to 1, the elastic
     *                       stiffness.
     */
    virtual void
    assemble_tangent(const NodeConstraints<dim> &constraints,
                     const double                elastic_share,
                     TangentMatrix<dim>         &matrix) const = 0;

    /// What is known at a quadrature point.
    struct PointState
    {
      SymmetricComponents<2 * dim> stress;       ///< in Pa
      double                       volume_ratio; ///< current over unloaded
      std::vector<double>          law_state;    ///< see StateVariable
    };

    /// @param index  see ElementGrid::point_index(); of
    /// ElementGrid::local_cells.
    virtual PointState
    point_state(const unsigned int index) const = 0;

    /// Give a quadrature point a state from which the next step starts.
    virtual void
    set_point_state(const unsigned int index, const PointState &state) = 0;

    /// Displace the reference configuration itself, as edges are curved: that
    /// strains nothing.
    /// @param displacement  with ghost entries.
    virtual void
    move_reference(const Vector &displacement) = 0;

    /// Smallest ratio, over all ranks' quadrature points, of the volume at the
    /// last evaluate_forces() to that at the start of the step; not above 1.
    /// Collective.
    virtual double
    smallest_volume_ratio() const = 0;

    /// Energies of the material in J (plane strain: per m of depth).
    struct Energies
    {
      double elastic;    ///< stored, as far as the law knows it
      double dissipated; ///< plastic work since the unloaded state
    };

    /// At the start of the step, on all ranks together. Collective.
    virtual Energies
    energies() const = 0;

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
    explicit Equilibrium(const ElementGrid<dim> &grid)
      : nodal_weight(grid.make_vector())
    {}

    Vector nodal_weight;
    double time_step       = 0.;
    bool   has_large_steps = false;
  };



  /// For the law that the parameters name. Throws InputError.
  template <int dim>
  std::unique_ptr<Equilibrium<dim>>
  make_equilibrium(const ElementGrid<dim>   &grid,
                   const Formulation         formulation,
                   const MaterialParameters &material,
                   const Tensor<1, dim>     &gravity);
} // namespace Sandglass

#endif
