#ifndef sandglass_flow_updated_lagrangian_motion_updated_lagrangian_flow_h
#define sandglass_flow_updated_lagrangian_motion_updated_lagrangian_flow_h

#include <sandglass/flow/dynamic_flow.h>
#include <sandglass/flow/updated_lagrangian/motion/moving_body.h>
#include <sandglass/flow/updated_lagrangian/motion/wall_sums.h>
#include <sandglass/flow/updated_lagrangian/rezoning/rezoning_criterion.h>

#include <memory>

namespace Sandglass
{
  /**
   * The flow by updated-Lagrangian finite elements (paper, Section 5.3;
   * doc/theory.md): steps of Newmark's method with unilateral frictional
   * contact, and re-zoning where elements degrade or a step has no solution.
   *
   * Each rank computes all of it; what is summed over ranks is the first one's.
   * Views show quadrature points as particles.
   */
  class UpdatedLagrangianFlow : public DynamicFlow<2>
  {
  public:
    /// All arguments have to outlive the object. Throws InputError as
    /// MotionSetting does.
    UpdatedLagrangianFlow(const Scene<2>                    &scene,
                          const MaterialParameters          &material,
                          const WallParameters              &walls,
                          const UpdatedLagrangianParameters &parameters,
                          const StaticStageParameters       &static_parameters,
                          const double                      &end_time,
                          ConditionalOStream                &log);

    void
    step() override;

    bool
    is_finished() const override
    {
      return time.time >= end_time * (1. - 1e-12);
    }

    void
    save(boost::archive::binary_oarchive &archive) const override;

    void
    load(boost::archive::binary_iarchive &archive) override;

    /// Nothing: ranks don't share the work.
    std::vector<double>
    cell_work() const override
    {
      return std::vector<double>(setting.scene.mesh.cells.size(), 0.);
    }

    void
    start_from(const InitialStateFunction<2>   &initial_state,
               const std::vector<WallForce<2>> &wall_forces) override;

    /// Nothing: the state at rest is one of these very equations.
    Settling
    settle() override
    {
      return {};
    }

    /// Nothing: this flow has no gates.
    void
    start_wall_records_anew() override
    {}

    /// Null where no material is left.
    const MovingBody *
    moving_body() const
    {
      return body.get();
    }

    unsigned int
    n_rezonings() const
    {
      return rezonings;
    }

    /// Mesh the material anew, whatever its elements are like.
    void
    rezone(const std::string &reason);

  private:
    // What views show.

    const Clock &
    clock() const override
    {
      return time;
    }

    FlowTotals
    totals() const override;

    /// Infinite: the method is implicit.
    double
    critical_time_step(const bool is_exact) const override;

    WallArea
    wall_area() const override;

    WallRecords
    wall_records() const override;

    std::vector<StateVariable>
    state_variables() const override;

    unsigned int
    n_particles() const override;

    void
    for_each_particle(const std::function<void(const ParticleRecord &)>
                        &function) const override;

    GridRecords
    grid() const override;

    /// The scene's filled cells, with no state yet.
    TriangleMesh
    initial_mesh() const;

    /// Add what the step has done to the sums over time.
    void
    end_step();

    /// Re-zone if elements ask for it.
    void
    keep_elements_good();

    void
    make_body(const MaterialState &state, const double first_step);

    const MotionSetting     setting;
    const double           &end_time;
    ConditionalOStream     &log;
    const bool              is_first_rank;
    const RezoningCriterion criterion;

    std::unique_ptr<MovingBody> body;
    Clock                       time;
    WallSums                    walls;
    unsigned int                rezonings = 0;
    /// Of the worst element when the mesh was made.
    double quality_of_new_mesh = 1.;
    double mass_removed = 0., mass_lost = 0.; ///< in kg
    /// By plastic flow until the last re-zoning, and by friction, in J.
    double dissipated_before = 0., friction_dissipation = 0.;
  };
} // namespace Sandglass

#endif
