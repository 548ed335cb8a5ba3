#ifndef sandglass_walls_friction_h
#define sandglass_walls_friction_h

#include <sandglass/walls/coulomb.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Sandglass
{
  using namespace dealii;

  /// What a node of the grid remembers of its contact with one support.
  template <int dim>
  struct FrictionMemory
  {
    Tensor<1, dim> force; ///< tangential, in N, on the material
    bool           is_sliding = false;
    double         mass       = 0.; ///< in the last step, in kg; 0: none yet

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &force &is_sliding &mass;
    }
  };

  /// What friction does in one step.
  template <int dim>
  struct FrictionStep
  {
    Tensor<1, dim> force; ///< on the material at the end of the step, in N
    /// In J, never negative: the slip's work that no spring has kept.
    double dissipation;
  };

  /// How the friction of a sliding node goes on.
  enum class FrictionUpdate
  {
    /**
     * Elastically with the slip, as from any other state, up to Coulomb's
     * limit.
     */
    return_mapping,
    /**
     * The paper's case I.2: at the limit, against the node's velocity. Where
     * that velocity is noise around zero, friction turns round by twice the
     * limit from one step to the next, so material at rest loses its wall
     * friction.
     */
    velocity_sign
  };

  /**
   * Coulomb's law with penalised sticking in time, for one node and one step
   * (paper, Section 4.2, cases I.1 and I.2). Velocities are tangential, and
   * relative to the wall's.
   *
   * The paper's trial force F - c_T v dt needs the velocity at the end of the
   * step, which the force itself changes. It is solved for both together, so
   * that sticking needs no smaller time step, and a sliding node is stopped
   * rather than turned back by its friction.
   */
  template <int dim>
  class PenaltyFriction
  {
  public:
    /**
     * @param penalty        c_T in N/m^3
     * @param penalty_limit  largest c_T A dt^2 / m of a node; 0: none
     */
    PenaltyFriction(const double         penalty,
                    const double         penalty_limit,
                    const FrictionUpdate update)
      : penalty(penalty)
      , penalty_limit(penalty_limit)
      , update(update)
    {}

    /**
     * The tangential force on the material, and what it dissipates.
     *
     * @param[in,out] memory  updated to the end of the step.
     * @param limit           mu times the normal force, >= 0, in N.
     * @param velocity        at the step's start, in m/s.
     * @param free_velocity   at the step's end without friction, in m/s.
     * @param mass            of the node, in kg.
     * @param area            of wall that belongs to the node, in m^2.
     * @param time_step       in s.
     */
    FrictionStep<dim>
    step(FrictionMemory<dim>  &memory,
         const double          limit,
         const Tensor<1, dim> &velocity,
         const Tensor<1, dim> &free_velocity,
         const double          mass,
         const double          area,
         const double          time_step) const
    {
      Tensor<1, dim> start_force =
        force_at_new_mass(memory, mass, area, time_step);
      if (update == FrictionUpdate::velocity_sign && memory.is_sliding &&
          velocity.norm_square() > 0.)
        {
          start_force = (-limit / velocity.norm()) * velocity;
          const Tensor<1, dim> end_velocity =
            free_velocity + time_step / mass * start_force;
          if (velocity * end_velocity > 0.)
            {
              memory.force = start_force;
              return {start_force, -time_step * (start_force * end_velocity)};
            }
        }

      const double         spring     = stiffness(mass, area, time_step);
      const double         stretching = spring * time_step;
      const double         yielding   = 1. + stretching * time_step / mass;
      const Tensor<1, dim> trial =
        (start_force - stretching * free_velocity) / yielding;
      const auto friction = coulomb(trial, limit);
      memory.is_sliding   = friction.is_sliding;
      memory.force        = friction.force;
      // The plastic slip's work, and what the step's end instead of its course
      // takes from the spring: the slip's work less what the spring keeps.
      return {friction.force,
              (yielding * (friction.force * (trial - friction.force)) +
               0.5 * (friction.force - start_force).norm_square()) /
                spring};
    }

    /// What a node's spring keeps, in J.
    double
    energy(const FrictionMemory<dim> &memory,
           const double               area,
           const double               time_step) const
    {
      return memory.mass == 0. ? 0. :
                                 0.5 * memory.force.norm_square() /
                                   stiffness(memory.mass, area, time_step);
    }

    /**
     * Let the force of a sticking node follow a displacement of the material
     * that step() has not known of.
     *
     * @param velocity   tangential, beyond that at the step's end, in m/s.
     * @param area       of wall that belongs to the node, in m^2.
     * @param time_step  in s.
     */
    void
    stretch(FrictionMemory<dim>  &memory,
            const Tensor<1, dim> &velocity,
            const double          area,
            const double          time_step) const
    {
      if (!memory.is_sliding)
        memory.force -=
          stiffness(memory.mass, area, time_step) * time_step * velocity;
    }

  private:
    /**
     * Stiffness of the spring that holds a node, in N/m.
     *
     * The solution for force and velocity together takes the node's whole mass,
     * but v^L, with which the material moves, follows the node with a share of
     * it. A spring that the step hardly resolves would therefore swing.
     */
    double
    stiffness(const double mass,
              const double area,
              const double time_step) const
    {
      const double by_penalty = penalty * area;
      return penalty_limit > 0. ?
               std::min(by_penalty,
                        penalty_limit * mass / (time_step * time_step)) :
               by_penalty;
    }

    /**
     * The force in N that leaves the spring's energy F^2 / (2 k) unchanged
     * where the node's mass changes its stiffness. With its force unchanged, a
     * stretched spring whose node loses mass would give back more than it has
     * taken. Where the time step changes the stiffness the force stays, since
     * it is what holds material at rest.
     *
     * @param[in,out] memory  takes on the mass.
     */
    Tensor<1, dim>
    force_at_new_mass(FrictionMemory<dim> &memory,
                      const double         mass,
                      const double         area,
                      const double         time_step) const
    {
      const double old_mass = std::exchange(memory.mass, mass);
      if (old_mass == 0.)
        return memory.force;
      return std::sqrt(stiffness(mass, area, time_step) /
                       stiffness(old_mass, area, time_step)) *
             memory.force;
    }

    double         penalty;
    double         penalty_limit;
    FrictionUpdate update;
  };
} // namespace Sandglass

#endif
