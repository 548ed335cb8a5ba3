#ifndef sandglass_flow_particle_in_cell_contact_h
#define sandglass_flow_particle_in_cell_contact_h

#include <sandglass/base/own_function.h>
#include <sandglass/flow/flow_view.h>
#include <sandglass/flow/particle_in_cell/held_nodes.h>
#include <sandglass/flow/particle_in_cell/wall_impulse_sums.h>
#include <sandglass/walls/friction.h>
#include <sandglass/walls/friction_cones.h>
#include <sandglass/walls/wall_force.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <array>
#include <vector>

namespace Sandglass
{
  /**
   * Frictional contact of the material with axis and walls at the grid's nodes
   * (paper, Section 4.2).
   *
   * The paper's normal force keeps the acceleration into the wall zero, which
   * presumes that the velocity already is. Here the force is the impulse that
   * takes the velocity into the wall at the end of the step to zero, divided by
   * the step: the same where the velocity is zero, and right on impact too.
   *
   * Walls rub where one support alone holds a node; friction follows the
   * velocity relative to the wall's, which need not be at rest.
   *
   * Where walls meet, a node stays at rest as long as their friction cones
   * together bear the force that stops it (see FrictionCones). Otherwise it
   * slides along one of them, in space also along the edge of two, or leaves.
   * There friction has no spring: which
   * walls hold the node changes with the force's direction, and springs that
   * come and go would drive material round the corner for ever.
   */
  template <int dim>
  class Contact : public HeldNodes<dim>
  {
  public:
    using NodalSum = Sandglass::NodalSum<dim>;

    Contact(const Scene<dim> &scene, const WallParameters &parameters);

    Contact(const Contact &) = delete;

    /**
     * Add the contact forces' share to the nodal accelerations.
     *
     * @param sums            of the step, finished.
     * @param time_step       in s.
     * @param[in,out] acceleration  of the owned nodes, in m/s^2.
     */
    void
    apply(const NodalSumField<dim> &sums,
          const double              time_step,
          NodalField<dim>          &acceleration) SANDGLASS_OWN_FUNCTION;

    /**
     * Start from the friction that holds the material at rest: without it the
     * walls' share of the weight would fall until they stick again. Where an
     * outlet has opened, its share goes over to the walls that have had the
     * plane in common with it. Collective.
     *
     * @param wall_forces  of the state at rest, each node's on any rank.
     */
    void
    start_from(const std::vector<WallForce<dim>> &wall_forces);

    /**
     * Let the springs of sticking friction follow the material, which moves
     * with v^L and not with the nodes' velocity at the end of the step.
     * Otherwise the swing of the nodes' mass between the two would stretch the
     * springs, and material at rest would tremble and creep.
     *
     * @param time_step  of this step, in s.
     */
    void
    stretch_friction(const NodalField<dim> &mapped_velocity,
                     const double           time_step);

    /**
     * Add `forces`, in N, to those of the step for which apply() was called
     * last: they hold its nodes beyond what apply() has found.
     */
    void
    add_forces(const NodalField<dim> &forces, const double time_step);

    /// Add to the records of the last step what has held particles instead of
    /// nodes.
    void
    add_impulses(const std::vector<WallImpulse<dim>> &impulses);

    /// What the springs of sticking friction keep, in J, this rank's nodes.
    double
    friction_energy() const;

    /// What wall friction has dissipated since the start, in J, this rank's
    /// nodes and particles. Never falls.
    double
    friction_dissipation() const
    {
      return dissipation;
    }

    /// Work that moving walls have done on the material since the start, in J,
    /// this rank's nodes and particles.
    double
    wall_work() const
    {
      return work;
    }

    void
    set_energies(const double friction_dissipation, const double wall_work)
    {
      dissipation = friction_dissipation;
      work        = wall_work;
    }

    /// Start energies and records anew, but keep the friction that there is.
    void
    forget_records()
    {
      set_energies(0., 0.);
      start_records_anew();
    }

    /// Start the walls' records anew, but keep all else.
    void
    start_records_anew()
    {
      summed_time = 0.;
      sums.clear();
    }

    /// What this rank's nodes have felt of walls since the start. Collective.
    WallRecords
    records() const
    {
      return {summed_time, sums.records()};
    }

    /// What they have felt of the axis since the start, in N s.
    Tensor<1, dim>
    axis_impulse() const
    {
      return sums.axis_impulse();
    }

    WallArea
    wall_area() const;

    /// Complete on rank 0. Collective.
    void
    save(boost::archive::binary_oarchive &archive) const;

    void
    load(boost::archive::binary_iarchive &archive);

  private:
    using HeldNodes<dim>::along_support;
    using HeldNodes<dim>::field_indices;
    using HeldNodes<dim>::held_velocity;
    using HeldNodes<dim>::holding;
    using HeldNodes<dim>::holding_supports;
    using HeldNodes<dim>::nodes;

    /// Of the supports of one node.
    using Memories = std::array<FrictionMemory<dim>, dim>;

    /// Whether this support and no other one held a node; walls rub only then.
    bool
    is_held_by_one(const unsigned int n, const unsigned int support) const
    {
      return holding[n] == 1u << support && !nodes[n].is_fixed;
    }

    /// Whether two supports hold a node in space, which leaves it a line to
    /// move along.
    bool
    is_on_edge(const unsigned int n) const
    {
      return dim == 3 && n_supports(holding[n]) == 2 && !nodes[n].is_fixed;
    }

    /// Whether this support is a wall, and no other wall holds a node that is
    /// free to move along it. In space a symmetry plane may hold it as well.
    bool
    rubs_alone(const unsigned int n, const unsigned int support) const
    {
      const auto &supports = nodes[n].supports;
      if (supports[support].is_axis || !contains(holding[n], support))
        return false;
      if (!is_on_edge(n))
        return is_held_by_one(n, support);
      for (unsigned int s = 0; s < supports.size(); ++s)
        if (s != support && contains(holding[n], s) && !supports[s].is_axis)
          return false;
      return true;
    }

    /// Take away the momentum that the material's mirror image beyond the axis
    /// cancels, so that half a silo moves like the whole.
    static void
    cancel_by_image(const BoundaryNode<dim> &node, Tensor<1, dim> &velocity);

    /**
     * Record what the one support that holds node `n` does to it, friction
     * included; returns friction's change of the velocity, in m/s.
     *
     * @param normal_impulse  >= 0 where a wall presses, in N s.
     */
    Tensor<1, dim>
    wall_reaction(const unsigned int    n,
                  const unsigned int    support,
                  const double          mass,
                  const double          normal_impulse,
                  const Tensor<1, dim> &velocity,
                  const Tensor<1, dim> &free_velocity) SANDGLASS_OWN_FUNCTION;

    /**
     * Friction of the walls that hold a node on an edge: what they can rub
     * together, or of one wall beside a symmetry plane what it does anywhere.
     * Records it; returns its change of the velocity, in m/s.
     *
     * @param sticks   whether the walls stop the node, whatever it takes.
     * @param impulse  of the supports along their normals, in N s.
     * @param free_velocity  at the end of the step without friction, in m/s.
     */
    Tensor<1, dim>
    edge_reaction(const unsigned int    n,
                  const double          mass,
                  const bool            sticks,
                  const Tensor<1, dim> &impulse,
                  const Tensor<1, dim> &velocity,
                  const Tensor<1, dim> &free_velocity);

    /// Record the friction of the one wall that holds a node; returns its
    /// change of the velocity, in m/s.
    Tensor<1, dim>
    friction_of_wall(const unsigned int    n,
                     const unsigned int    support,
                     const double          mass,
                     const double          normal_impulse,
                     const Tensor<1, dim> &slip,
                     const Tensor<1, dim> &free_slip);

    /// Whether friction at a node follows the rule for places where walls meet.
    bool
    is_corner(const unsigned int n) const
    {
      return cones[n].are_several();
    }

    /// Whether the walls that meet at a node can stop it, if it would move at
    /// `free_velocity` without them.
    bool
    sticks_in_corner(const unsigned int    n,
                     const double          mass,
                     const Tensor<1, dim> &free_velocity) const;

    /// Forget the friction of a support that doesn't rub.
    void
    release_friction(const unsigned int n, const unsigned int support);

    /// Friction of the one wall that holds a node, not of the axis.
    FrictionStep<dim>
    find_friction(const unsigned int    n,
                  const unsigned int    support,
                  const double          mass,
                  const double          normal_impulse,
                  const Tensor<1, dim> &slip,
                  const Tensor<1, dim> &free_slip);

    /// Record the impulse by which a node's supports hold it.
    void
    record_normal_impulse(const unsigned int n, const Tensor<1, dim> &impulse);

    const PenaltyFriction<dim> friction;
    const bool                 stops_velocity; ///< or else only acceleration
    /// Whether the axis cancels momentum instead of stopping it.
    const bool        has_image;
    const Scene<dim> &scene;

    /// Of the nodes; none where the rule for places where walls meet is off.
    std::vector<FrictionCones<dim>> cones;

    double                      time_step = 0.; ///< the last one, in s
    std::vector<Tensor<1, dim>> end_velocities; ///< of the nodes, in m/s
    std::vector<Memories>       memories;
    WallImpulseSums<dim>        sums;

    double dissipation = 0.;
    double work        = 0.;
    double summed_time = 0.;
  };
} // namespace Sandglass

#endif
