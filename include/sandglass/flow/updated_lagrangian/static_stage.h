#ifndef sandglass_flow_updated_lagrangian_static_stage_h
#define sandglass_flow_updated_lagrangian_static_stage_h

#include <deal.II/base/conditional_ostream.h>

#include <sandglass/base/table.h>
#include <sandglass/flow/flow.h>
#include <sandglass/flow/updated_lagrangian/equilibrium.h>
#include <sandglass/flow/updated_lagrangian/load_predictor.h>
#include <sandglass/flow/updated_lagrangian/rest_solver.h>
#include <sandglass/flow/updated_lagrangian/settled_layers.h>
#include <sandglass/flow/updated_lagrangian/static_stage_parameters.h>
#include <sandglass/flow/updated_lagrangian/static_state.h>
#include <sandglass/flow/updated_lagrangian/wall_contact.h>
#include <sandglass/material/material_parameters.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Sandglass
{
  /// What static.vtu shows of a cell: means over its quadrature points.
  struct StaticCell
  {
    std::array<double, 6> stress;       ///< in Pa
    double                volume_ratio; ///< current over initial
  };

  /// Fields of static.vtu in cells, beside the displacement at nodes.
  extern const std::vector<Column<StaticCell>> static_cell_table;

  /**
   * The state at rest under gravity with the outlet closed, by the updated
   * Lagrangian finite element method (paper, Section 5; doc/theory.md): load
   * steps of RestSolver, cut where they lead nowhere. Where the whole weight is
   * carried but the material is not at rest, steps without more load follow.
   *
   * As a flow it stands still in time: a step adds load, the walls' impulses
   * are those of one second, and nothing moves.
   */
  template <int dim>
  class StaticStage : public Flow
  {
  public:
    /// @param element_order  see ElementGrid; views and checkpoints are for
    /// linear elements, but for the walls' records, which are for both.
    StaticStage(const Scene<dim>            &scene,
                const MaterialParameters    &material_parameters,
                const WallParameters        &wall_parameters,
                const StaticStageParameters &parameters,
                ConditionalOStream          &log,
                const unsigned int           element_order = 1);

    /**
     * All load steps from here on. Logs the number of unknowns, and one line
     * per load step. Collective. Throws RunError as step() does.
     *
     * @param after_load_step  is called with the share of the weight that has
     *                         come to rest.
     */
    StaticState<dim>
    run(const std::function<void(const double)> &after_load_step = {});

    /// What run() has found, for another layer to be placed on it. Collective.
    SettledLayers<dim>
    settled_layers() const;

    /**
     * Before run(): let the material that another stage has found at rest be
     * where it is, with its stress and its weight. The rest of this scene's
     * material is new: without stress in the configuration that it gets by the
     * displacement of what it lies on, and its weight is what load steps apply.
     */
    void
    place_on(const SettledLayers<dim> &layers);

    /// The next load step, cut until its end is acceptable. Collective. Throws
    /// RunError where the smallest one doesn't.
    void
    step() override;

    bool
    is_finished() const override;

    void
    save(boost::archive::binary_oarchive &archive) const override;

    void
    load(boost::archive::binary_iarchive &archive) override;

    /// Nothing: load steps are not what the scene's cells are shared out by.
    std::vector<double>
    cell_work() const override
    {
      return std::vector<double>(scene.triangulation.n_active_cells(), 0.);
    }

    /**
     * Write the result of run() to static.vtu, one file for all ranks.
     * Collective.
     */
    void
    write_vtu(const std::string &directory) const;

  private:
    using Vector = DisplacementVector;

    // What views show.

    const Clock &
    clock() const override
    {
      return time;
    }

    FlowTotals
    totals() const override;

    /// Infinite: there are no steps in time.
    double
    critical_time_step(const bool is_exact) const override;

    WallArea
    wall_area() const override;

    WallRecords
    wall_records() const override;

    std::vector<StateVariable>
    state_variables() const override;

    /// None: material is in elements.
    unsigned int
    n_particles() const override
    {
      return 0;
    }

    void
    for_each_particle(
      const std::function<void(const ParticleRecord &)> &) const override
    {}

    /// The filled cells, undeformed.
    GridRecords
    grid() const override;

    bool
    is_fully_loaded() const
    {
      return load_share >= 1. - 1e-12;
    }

    /// Under that share of the weight, or of the new layer's.
    RestResult
    solve(const double goal, Vector &increment);

    /// Decide whether an accepted load step has led to rest.
    void
    end_load_step(const RestResult &result);

    /// Log a load step, and add it to the effort.
    void
    count(const double load_share, const RestResult &result);
    void
    accept(Vector &increment);
    StaticState<dim>
    make_state() const;
    /// Mean of the state at a cell's quadrature points.
    StaticCell
    mean_state(const CellAccessor<dim> &cell) const;
    using CellIterator = typename DoFHandler<dim>::active_cell_iterator;

    /// Mass that the weight of a cell's node stands for, in kg; 0 without
    /// gravity.
    double
    nodal_mass(const CellIterator &cell, const unsigned int vertex) const;

    const Scene<dim>            &scene;
    const MaterialParameters    &material;
    const StaticStageParameters &parameters;
    ConditionalOStream          &log;

    const FilledGrid<dim>                   filled_grid;
    const std::unique_ptr<Equilibrium<dim>> equilibrium;
    WallContact<dim>                        contact;
    RestSolver<dim>                         solver;
    const bool                              has_weight;

    Clock         time;                  ///< counts load steps
    double        load_share    = 0.;    ///< of the whole weight
    bool          is_at_rest    = false; ///< under that load
    unsigned int  n_repetitions = 0;     ///< load steps without more load
    double        largest_load_step;     ///< as such a share
    double        load_step;             ///< to be tried next, likewise
    Vector        displacement;          ///< since the unloaded state
    LoadPredictor predictor;
    StaticEffort  effort;

    /// Nodal forces of the layers at rest, and with the new one, in N; none
    /// without layers.
    std::unique_ptr<Vector> settled_weight, whole_weight;
  };
} // namespace Sandglass

#endif
