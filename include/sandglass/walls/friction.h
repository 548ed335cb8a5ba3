#ifndef sandglass_walls_friction_h
#define sandglass_walls_friction_h

#include <algorithm>
#include <cmath>
#include <utility>

namespace Sandglass
{
  /// What a node of the grid remembers of its contact with one wall.
  struct FrictionMemory
  {
    double tangential_force = 0.; ///< in N, on the material
    bool   is_sliding       = false;
    double mass             = 0.; ///< in the last step, in kg; 0: none yet

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &tangential_force &is_sliding &mass;
    }
  };

  /// How the friction of a sliding node goes on.
  enum class FrictionUpdate
  {
    /**
     * As from any other state: elastically with the slip, up to Coulomb's
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
   * The Coulomb law with penalised sticking, for one node and one step (paper,
   * Section 4.2, cases I.1 and I.2), in one tangential direction.
   *
   * The paper's trial force F - c_T v dt needs the velocity at the end of the
   * step, which the force itself changes. It is solved for both together, so
   * that sticking needs no smaller time step, and a sliding node is stopped
   * rather than turned back by its friction.
   */
  class CoulombFriction
  {
  public:
    /**
     * @param coefficient  mu = tan(wall friction angle)
     * @param penalty      c_T in N/m^3
     * @param penalty_limit  largest c_T A dt^2 / m of a node; 0: none
     */
    CoulombFriction(const double         coefficient,
                    const double         penalty,
                    const double         penalty_limit,
                    const FrictionUpdate update)
      : coefficient(coefficient)
      , penalty(penalty)
      , penalty_limit(penalty_limit)
      , update(update)
    {}

    /**
     * The tangential force on the material at the end of the step, in N.
     *
     * @param[in,out] memory   updated to the end of the step.
     * @param normal_force     compression, >= 0, in N.
     * @param velocity         tangential velocity at the step's start, in m/s.
     * @param free_velocity    velocity at the step's end without friction.
     * @param mass             of the node, in kg.
     * @param area             of wall that belongs to the node, in m^2.
     * @param time_step        in s.
     */
    double
    tangential_force(FrictionMemory &memory,
                     const double    normal_force,
                     const double    velocity,
                     const double    free_velocity,
                     const double    mass,
                     const double    area,
                     const double    time_step) const
    {
      const double limit = coefficient * normal_force;

      double start_force = force_at_new_mass(memory, mass, area, time_step);
      if (update == FrictionUpdate::velocity_sign && memory.is_sliding &&
          velocity != 0.)
        {
          const double force        = -std::copysign(limit, velocity);
          const double end_velocity = free_velocity + time_step * force / mass;
          if (velocity * end_velocity > 0.)
            {
              memory.tangential_force = force;
              return force;
            }
          start_force = force;
        }

      const double stretching  = stiffness(mass, area, time_step) * time_step;
      const double trial_force = (start_force - stretching * free_velocity) /
                                 (1. + stretching * time_step / mass);
      memory.is_sliding       = std::abs(trial_force) > limit;
      memory.tangential_force = std::clamp(trial_force, -limit, limit);
      return memory.tangential_force;
    }

    /**
     * Of a sticking node: let the force follow a displacement of the material
     * that tangential_force() has not known of.
     *
     * @param velocity   beyond that at the step's end, tangential, in m/s.
     * @param area       of wall that belongs to the node, in m^2.
     * @param time_step  in s.
     */
    void
    stretch(FrictionMemory &memory,
            const double    velocity,
            const double    area,
            const double    time_step) const
    {
      if (!memory.is_sliding)
        memory.tangential_force -=
          stiffness(memory.mass, area, time_step) * time_step * velocity;
    }

  private:
    /**
     * Of the spring that holds a node, in N/m.
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
    double
    force_at_new_mass(FrictionMemory &memory,
                      const double    mass,
                      const double    area,
                      const double    time_step) const
    {
      const double old_mass = std::exchange(memory.mass, mass);
      if (old_mass == 0.)
        return memory.tangential_force;
      return memory.tangential_force *
             std::sqrt(stiffness(mass, area, time_step) /
                       stiffness(old_mass, area, time_step));
    }

    double         coefficient;
    double         penalty;
    double         penalty_limit;
    FrictionUpdate update;
  };
} // namespace Sandglass

#endif
