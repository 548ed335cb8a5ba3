#ifndef sandglass_flow_particle_in_cell_contact_h
#define sandglass_flow_particle_in_cell_contact_h

#include <sandglass/flow/particle_in_cell/nodal_fields.h>
#include <sandglass/flow/particle_in_cell/wall_impulse.h>
#include <sandglass/flow/flow_view.h>
#include <sandglass/scene/scene.h>
#include <sandglass/walls/boundary_nodes.h>
#include <sandglass/walls/friction.h>
#include <sandglass/walls/wall_force.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <array>
#include <map>
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
   * A node between two walls obeys both: it is held by one of them if the
   * other lets it pass, and by both otherwise.
   */
  template <int dim>
  class Contact
  {
  public:
    using NodalSum = Sandglass::NodalSum<dim>;

    Contact(const Scene<dim> &scene, const WallParameters &parameters);

    /**
     * Add the contact forces' share to the nodal accelerations.
     *
     * @param sums            of the step, finished.
     * @param time_step       in s.
     * @param[in,out] acceleration  of the owned nodes, in m/s^2.
     */
    void
    apply(const NodalSumField<dim> &sums,
          const double                              time_step,
          NodalField<dim>                          &acceleration);

    /**
     * Take away the part of the mapped velocity v^L that points into a wall or
     * off the axis. Particles that follow it cannot pass the wall, and the
     * strain at the wall is that of material which stays inside.
     */
    void
    constrain(NodalField<dim> &velocity) const;

    /**
     * Start from the friction that holds the material at rest: without it the
     * walls' share of the weight would fall until they stick again. Collective.
     *
     * @param wall_forces  of the state at rest, each node's on any rank.
     */
    void
    start_from(const std::vector<WallForce<dim>> &wall_forces);

    /**
     * Let the springs of sticking friction follow the material, which moves
     * with v^L and not with the nodes' velocity at the end of the step: what
     * the nodes' mass swings by between the two would otherwise stretch the
     * springs, and material at rest would tremble and creep.
     *
     * @param time_step  of this step, in s.
     */
    void
    stretch_friction(const NodalField<dim> &mapped_velocity,
                     const double           time_step);

    /**
     * Set to zero what a nodal field has in the directions in which apply() has
     * found a wall to hold a node.
     */
    void
    release_held(NodalField<dim> &field) const;

    /// As release_held(), where the axis or a fixed corner holds a node for
    /// ever.
    void
    release_always_held(NodalField<dim> &field) const;

    /**
     * Add to the forces of the step for which apply() was called last those
     * that hold its nodes beyond what it has found, in N.
     */
    void
    add_forces(const NodalField<dim> &forces, const double time_step);

    /**
     * Add to the records of the last step what has held particles instead of
     * nodes. Each end of the wall's face gets the share that its linear shape
     * function has at the particle.
     */
    void
    add_impulses(const std::vector<WallImpulse<dim>> &impulses);

    /// Work done against wall friction since the start, in J, this rank's
    /// nodes and particles.
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
      return 0.;
    }

    void
    set_energies(const double friction_dissipation, const double wall_work);

    /// What this rank's nodes have felt since the start. Collective.
    WallRecords
    records() const;

    WallArea
    wall_area() const;

    /// Complete on rank 0. Collective.
    void
    save(boost::archive::binary_oarchive &archive) const;

    void
    load(boost::archive::binary_iarchive &archive);

  private:
    struct Node
    {
      unsigned int             index; ///< in the nodal fields
      BoundaryNode<dim>             boundary;
      std::array<WallForce<dim>, 2> impulse; ///< forces times time, in N s
      /// The supports that held it when apply() was called last.
      unsigned int   holding = 0;
      Tensor<1, dim> end_velocity; ///< at the end of that step, in m/s

      /// Whether this support and no other one held it; walls rub only then.
      bool
      is_held_by_one(const unsigned int support) const
      {
        return holding == 1u << support && !boundary.is_fixed;
      }
    };

    /// Set to zero what the supports `holding(node, value)` hold of a nodal
    /// field's value.
    template <typename Holding>
    void
    release(NodalField<dim> &field, const Holding &holding) const;

    /// Take away what the momentum of the material's mirror image beyond the
    /// axis cancels, so that half a silo moves like the whole.
    static void
    cancel_by_image(const BoundaryNode<dim> &node, Tensor<1, dim> &velocity);

    /// Which of a node's supports hold it: bit k for support k.
    static unsigned int
    holding_supports(const BoundaryNode<dim> &node, const Tensor<1, dim> &velocity);

    /// What is left of a velocity that the given supports hold.
    static Tensor<1, dim>
    held_velocity(const BoundaryNode<dim>   &node,
                  const unsigned int    holding,
                  const Tensor<1, dim> &velocity);

    /// Friction of the wall `support`, and the record of its impulse.
    Tensor<1, dim>
    wall_reaction(Node                 &node,
                  FrictionMemory       &memory,
                  const unsigned int    support,
                  const double          mass,
                  const double          normal_impulse,
                  const Tensor<1, dim> &velocity,
                  const Tensor<1, dim> &free_velocity,
                  const double          time_step);

    void
    record_normal_impulses(Node &node, const Tensor<1, dim> &impulse) const;

    /// Impulses of the two supports of each node.
    using Impulses = std::vector<std::array<WallForce<dim>, 2>>;

    /// The nodes' records with those on particles. Collective, since a
    /// particle's wall may have a node of another rank.
    Impulses
    impulses() const;

    /// Position of an end of a wall's face, and the face's normal times its
    /// length.
    using WallPlace = std::array<double, 4>;

    const CoulombFriction friction;
    const bool            stops_velocity; ///< or else only acceleration
    /// Whether the axis cancels momentum instead of stopping it.
    const bool        has_image;
    const MPI_Comm    communicator;
    const Scene<dim> &scene;
    std::vector<Node> nodes;

    /// The friction memory of each support.
    std::vector<std::array<FrictionMemory, 2>> memories;

    /// Impulses on particles, which the nodes' records lack, in N s.
    std::map<WallPlace, Tensor<1, dim>> impulses_on_particles;

    double dissipation = 0.;
    double summed_time = 0.;
  };
} // namespace Sandglass

#endif
