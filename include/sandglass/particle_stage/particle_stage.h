#ifndef sandglass_particle_stage_particle_stage_h
#define sandglass_particle_stage_particle_stage_h

#include <sandglass/material/material_parameters.h>
#include <sandglass/particle_stage/clock.h>
#include <sandglass/particle_stage/contact.h>
#include <sandglass/particle_stage/nodal_fields.h>
#include <sandglass/particle_stage/particle_stage_parameters.h>
#include <sandglass/particle_stage/relocation.h>
#include <sandglass/particle_stage/step_part.h>
#include <sandglass/particles/seeding.h>
#include <sandglass/walls/wall_parameters.h>

#include <functional>
#include <limits>
#include <memory>

namespace Sandglass
{
  /// How ranks have waited for the one with most work, since the cells were
  /// shared out.
  struct Waiting
  {
    double total = 0.; ///< in particle-steps, beyond that at the start
    /// Its work beyond the mean at the start, see cell_work(); negative: not
    /// known yet.
    double at_start = -1.;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &total &at_start;
    }
  };

  /**
   * The explicit particle-in-cell stage (paper, Section 4.4) as observers and
   * the run see it, whatever its compile-time choices.
   */
  class ParticleStage
  {
  public:
    virtual ~ParticleStage() = default;

    /// One pass through Section 4.4. Throws RunError. Collective.
    virtual void
    step() = 0;

    bool
    is_finished() const
    {
      return clock.time >= parameters.end_time * (1. - 1e-12);
    }

    /**
     * The critical time step in s for the particles' positions. Collective;
     * costs about two steps.
     */
    virtual double
    critical_time_step() = 0;

    /// The same, or with automatic steps the one found last, at most
    /// `Time step interval` steps ago, which costs nothing. Collective.
    double
    recent_critical_time_step();

    /// Largest speed of this rank's particles, in m/s.
    double
    largest_speed() const;

    /// What a particle starts from, beside being at rest.
    struct InitialState
    {
      Tensor<1, dim>   displacement; ///< in m
      SymmetricTensor4 stress;       ///< in Pa
      double           volume_ratio; ///< current over unstressed volume
    };

    using InitialStateFunction =
      std::function<InitialState(const unsigned int cell,
                                 const Point<dim>  &reference_point)>;

    /// Give each particle stress, density and displacement. Collective.
    virtual void
    set_initial_state(const InitialStateFunction &initial_state) = 0;

    virtual Point<dim>
    initial_position(const types::particle_index id) const = 0;

    const Scene                   &scene;
    const ParticleStageParameters &parameters;
    ParticleCloud                  cloud;
    NodalFields                    fields;
    Contact                        contact;
    Clock                          clock;

    /// The automatic step without the cut at the end, in s; 0: not known yet.
    double automatic_time_step = 0.;

    /// The stiffest node's when that was found, in 1/s^2.
    double last_local_eigenvalue = 0.;

    /// The critical step found when the automatic one was, in s; 0: none yet.
    double last_critical_time_step = 0.;

    /// For run/load_balance.h.
    Waiting waiting;

    /// Plastic work since the start on this rank, in J.
    double plastic_dissipation = 0.;

    /// Particle-steps of this rank since this process started.
    unsigned long particle_steps = 0;

    /// Masses that have left the grid on this rank.
    virtual RemovedMass &
    removed_mass() = 0;

    /// Told of each part of a step; usually nobody.
    StepWatcher *step_watcher = nullptr;

  protected:
    ParticleStage(const Scene                   &scene,
                  const WallParameters          &walls,
                  const ParticleStageParameters &parameters);

    void
    begin(const StepPart part) const
    {
      if (step_watcher != nullptr)
        step_watcher->begin(part);
    }

    /// Step of the table, or the automatic one, cut at the end time.
    double
    choose_time_step();

    /// Throws RunError, from time to time, if a particle is too fast.
    void
    check_speed() const;

    /// As critical_time_step(), with the nodal sums of this step at hand.
    virtual double
    find_critical_time_step() = 0;

    /**
     * A cheap measure, in 1/s^2, of the stiffest node that the sums of this
     * step show. Between two looks at the critical step, the step shrinks as
     * this grows: particles of very different mass that come together can
     * double the eigenvalue within a few steps.
     */
    virtual double
    local_eigenvalue() const = 0;

    /// In m/s.
    double speed_limit;

    /**
     * Critical step of the material as it is seeded, in s. The automatic step
     * is not based on a longer one: where little material is left, most of it
     * separated, the critical step is long or infinite, but falls within a few
     * steps when that material comes together again.
     */
    double seeded_critical_time_step = std::numeric_limits<double>::infinity();
    double seeded_local_eigenvalue   = 0.;
  };

  /// A particle stage with its particles seeded, unstressed and at rest.
  std::unique_ptr<ParticleStage>
  make_particle_stage(const Scene                   &scene,
                      const MaterialParameters      &material,
                      const WallParameters          &walls,
                      const ParticleStageParameters &parameters);
} // namespace Sandglass

#endif
