#ifndef sandglass_flow_particle_in_cell_particle_stage_h
#define sandglass_flow_particle_in_cell_particle_stage_h

#include <sandglass/base/compensated_sum.h>
#include <sandglass/flow/dynamic_flow.h>
#include <sandglass/flow/particle_in_cell/contact.h>
#include <sandglass/flow/particle_in_cell/feed_parameters.h>
#include <sandglass/flow/particle_in_cell/nodal_fields.h>
#include <sandglass/flow/particle_in_cell/outlet_masses.h>
#include <sandglass/flow/particle_in_cell/particle_stage_parameters.h>
#include <sandglass/flow/particle_in_cell/removed_mass.h>
#include <sandglass/flow/particle_in_cell/step_control.h>
#include <sandglass/flow/particle_in_cell/step_part.h>
#include <sandglass/particles/particle_cloud.h>
#include <sandglass/particles/particle_state.h>
#include <sandglass/walls/wall_parameters.h>

namespace Sandglass
{
  /**
   * The explicit particle-in-cell stage (paper, Section 4.4), as far as it
   * depends only on what a particle carries: what others see of it, and its
   * checkpoints. Its sums over particles are always those of the particles as
   * they are.
   */
  template <typename Layout>
  class ParticleStage : public DynamicFlow<Layout::dim>
  {
  public:
    static constexpr int dim = Layout::dim;

    using Scene  = Sandglass::Scene<dim>;
    using Cloud  = ParticleCloud<Layout>;
    using Blocks = ParticleBlocks<Layout>;
    using Block  = ParticleBlock<Layout>;
    using Parcel = Sandglass::Parcel<Layout>;

    bool
    is_finished() const override
    {
      return time.time >= parameters.end_time * (1. - 1e-12);
    }

    void
    save(boost::archive::binary_oarchive &archive) const override;

    void
    load(boost::archive::binary_iarchive &archive) override;

    std::vector<double>
    cell_work() const override;

    void
    start_from(const InitialStateFunction<dim>   &initial_state,
               const std::vector<WallForce<dim>> &wall_forces) override;

    void
    start_wall_records_anew() override
    {
      contact.start_records_anew();
    }

    /// By kinetic damping: particles are stopped whenever their kinetic energy
    /// has passed a maximum (Cundall 1982).
    Settling
    settle() override;

    /// Call `change(handler)`, which may change, add or remove particles; sums
    /// over them are found anew. Collective.
    template <typename Change>
    void
    edit_particles(const Change &change)
    {
      cloud.edit(change);
      sum_over_particles();
    }

    /// The same for `change(blocks)`, which may change particles where they
    /// are.
    template <typename Change>
    void
    edit_blocks(const Change &change)
    {
      change(cloud.change_blocks());
      sum_over_particles();
    }

    const Cloud &
    particles() const
    {
      return cloud;
    }

    const NodalFields<dim> &
    nodal_fields() const
    {
      return fields;
    }

    const Contact<dim> &
    wall_contact() const
    {
      return contact;
    }

    /// By plastic flow and wall friction since the start, in J, on this rank.
    double
    dissipation() const
    {
      return plastic_dissipation + contact.friction_dissipation();
    }

    const RemovedMass &
    removed_mass() const
    {
      return removed;
    }

    /// Where a particle was before the state at rest.
    virtual Point<dim>
    initial_position(const types::particle_index id) const = 0;

    const Scene                   &scene;
    const ParticleStageParameters &parameters;

    /// Who is told of each part of a step; usually nobody.
    StepWatcher *step_watcher = nullptr;

  protected:
    ParticleStage(const Scene                   &scene,
                  const WallParameters          &walls,
                  const ParticleStageParameters &parameters);

    // What views show.

    const Clock &
    clock() const override
    {
      return time;
    }

    WallArea
    wall_area() const override
    {
      return contact.wall_area();
    }

    WallRecords
    wall_records() const override
    {
      return contact.records();
    }

    unsigned int
    n_particles() const override
    {
      return cloud.n_locally_owned_particles();
    }

    void
    for_each_particle(const std::function<void(const ParticleRecord &)>
                        &function) const override;

    GridRecords
    grid() const override;

    double
    critical_time_step(const bool is_exact) const override;

    // What the stage with its compile-time choices made adds.

    /// Sum over all particles anew, to the nodes.
    virtual void
    sum_over_particles() = 0;

    /// How many particles have been fed at each place of this rank: pairs of
    /// the initial particle's id there and a number.
    virtual FedNumbers
    fed_numbers() const = 0;

    virtual void
    set_fed_numbers(const FedNumbers &numbers) = 0;

    /// Hand particles that are outside their cells over to the right ones.
    virtual void
    relocate_strays() = 0;

    virtual void
    set_initial_state(const InitialStateFunction<dim> &initial_state,
                      Parcel                          &particle) const = 0;

    /// Of the particles' present positions, in s.
    virtual double
    find_critical_time_step() const = 0;

    /**
     * A cheap measure, in 1/s^2, of the stiffest node that the sums of this
     * step show. Between two looks at the critical step, the step shrinks as
     * this grows: particles of very different mass that come together can
     * double the eigenvalue within a few steps.
     */
    virtual double
    local_eigenvalue() const = 0;

    /// The sums over the particles of each cell, for checkpoints: those that
    /// steps have added up would be others if they were found anew, by
    /// rounding.
    virtual std::vector<double>
    pack_cell_sums() const = 0;

    /// @param sums  of all ranks' cells.
    virtual void
    unpack_cell_sums(const std::vector<double> &sums) = 0;

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

    /// Largest speed of this rank's particles, in m/s.
    double
    largest_speed() const;

    Cloud            cloud;
    NodalFields<dim> fields;
    Contact<dim>     contact;
    Clock            time;
    StepControl      control;
    RemovedMass      removed;

    /// What has passed each of several outlets.
    OutletMasses<dim> outlets;

    /// What has been fed since the start on this rank, in kg.
    CompensatedSum mass_fed;

    /// Whether settle() makes the steps, in which nothing is fed.
    bool is_settling = false;

    /// Plastic work since the start on this rank, in J.
    double plastic_dissipation = 0.;

    /// Particle-steps of this rank since this process started.
    unsigned long particle_steps = 0;

  private:
    /// Take all particles' velocities away.
    void
    stop_particles();

    /// In m/s.
    const double speed_limit;
  };
} // namespace Sandglass

#include <sandglass/flow/particle_in_cell/particle_stage.templates.h>
#include <sandglass/flow/particle_in_cell/settling.templates.h>
#include <sandglass/flow/particle_in_cell/stage_checkpoint.templates.h>
#include <sandglass/flow/particle_in_cell/stage_view.templates.h>

#endif
