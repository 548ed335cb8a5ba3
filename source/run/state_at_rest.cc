#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/throw_law_failure.h>
#include <sandglass/flow/updated_lagrangian/settlement_check.h>
#include <sandglass/flow/updated_lagrangian/static_stage.h>
#include <sandglass/output/silo_measures.h>
#include <sandglass/run/state_at_rest.h>
#include <sandglass/run/static_to_particles.h>
#include <sandglass/scene/fill_layers.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    /// All of the static stage, with doubts about the material's stiffness
    /// where it settles too much or finds no state at rest.
    template <int dim>
    StaticState<dim>
    settle(StaticStage<dim>            &static_stage,
           const Scene<dim>            &scene,
           const Parameters            &parameters,
           Log                         &log,
           const std::function<void()> &after_load_step)
    {
      const MaterialParameters &material = parameters.material;
      RestProgress     progress(log, parameters.output.progress_interval);
      StaticState<dim> state;
      try
        {
          state = static_stage.run([&](const double load_share) {
            progress.after_load_step(load_share);
            after_load_step();
          });
        }
      catch (const LawFailure &failure)
        {
          throw_law_failure(std::string("State at rest: ") + failure.what(),
                            scene.communicator);
        }
      catch (const RunError &error)
        {
          throw RunError(error.what() + doubt_stiffness(scene, material));
        }
      check_settlement(state, scene, material, log.stream());
      return state;
    }



    /// Place layer on layer, but for the last one: what that has to lie on, if
    /// there is something.
    template <int dim>
    std::optional<SettledLayers<dim>>
    fill_all_layers_but_last(const Parameters            &parameters,
                             Part<dim>                   &part,
                             Log                         &log,
                             const std::function<void()> &after_load_step)
    {
      const FillLayers<dim> layers(part.scene.mesh, parameters.scene.n_layers);
      std::optional<SettledLayers<dim>> settled;
      unsigned int                      n_cells = 0;
      for (unsigned int n = 1; n < layers.n_layers; ++n)
        {
          const Mesh<dim>    mesh = fill_layers(part.scene.mesh, layers, n);
          const unsigned int n_filled =
            std::count_if(mesh.cells.begin(),
                          mesh.cells.end(),
                          [](const auto &cell) { return cell.is_filled; });
          if (n_filled == n_cells)
            continue; // a layer thinner than cells are high
          n_cells = n_filled;
          log.stream() << "Layer " << n << " of " << layers.n_layers
                       << std::endl;
          const Scene<dim> scene(mesh,
                                 parameters.walls,
                                 part.scene.formulation,
                                 part.scene.particles_per_cell,
                                 part.scene.gravity,
                                 part.scene.communicator,
                                 part.scene.partitioner,
                                 part.scene.cell_weights);
          StaticStage<dim> stage(scene,
                                 parameters.material,
                                 parameters.walls,
                                 parameters.static_stage,
                                 log.stream());
          if (settled)
            stage.place_on(*settled);
          stage.run([&](const double) { after_load_step(); });
          settled = stage.settled_layers();
        }
      log.stream() << "Layer " << layers.n_layers << " of " << layers.n_layers
                   << std::endl;
      return settled;
    }



    /// Where nothing can leave, let particles settle at their own rest.
    template <int dim>
    void
    settle_particles(const StaticStageParameters &parameters,
                     Part<dim>                   &part,
                     Log                         &log)
    {
      const auto &walls = part.scene.walls;
      if (!parameters.settles_particles || part.flow->is_finished() ||
          SiloMeasures<dim>(part.scene).has_open_outlet ||
          std::any_of(walls.begin(), walls.end(), [](const Wall<dim> &wall) {
            return wall.velocity.norm() > 0.;
          }))
        return;
      const Settling settling = part.flow->settle();
      log.stream() << "Particles settled in " << settling.n_steps
                   << " steps, largest speed then " << settling.largest_speed
                   << " m/s" << std::endl;
    }



    /// For a flow that each rank computes alone: each finds all of the state at
    /// rest, by the flow's own elements.
    template <int dim>
    AtRest
    find_on_each_rank(const Parameters            &parameters,
                      Part<dim>                   &part,
                      Log                         &log,
                      const std::function<void()> &after_load_step)
    {
      const Scene<dim> scene(part.scene.mesh,
                             parameters.walls,
                             part.scene.formulation,
                             part.scene.particles_per_cell,
                             part.scene.gravity,
                             MPI_COMM_SELF);
      StaticStage<dim> static_stage(
        scene,
        parameters.material,
        parameters.walls,
        parameters.static_stage,
        log.stream(),
        parameters.updated_lagrangian.element_order);
      const StaticState<dim> state =
        settle(static_stage, scene, parameters, log, after_load_step);
      carry_to_particles(state, scene, *part.flow, true);

      AtRest     result{static_stage.view().wall_records(), state.effort};
      const bool is_first =
        Utilities::MPI::this_mpi_process(part.scene.communicator) == 0;
      if (!is_first)
        result.wall_records.records.clear();
      else if (parameters.output.writes_grid)
        static_stage.write_vtu(parameters.output.directory);
      return result;
    }
  } // namespace



  template <int dim>
  std::optional<AtRest>
  find_state_at_rest(const Parameters            &parameters,
                     Part<dim>                   &part,
                     Log                         &log,
                     TimerOutput                 &timings,
                     const std::function<void()> &after_load_step)
  {
    if (!parameters.static_stage.is_enabled)
      return {};
    TimerOutput::Scope static_scope(timings, Timing::static_stage);
    if (parameters.flow.method == FlowParameters::Method::updated_lagrangian)
      return find_on_each_rank(parameters, part, log, after_load_step);
    StaticStage<dim> static_stage(part.scene,
                                  parameters.material,
                                  parameters.walls,
                                  parameters.static_stage,
                                  log.stream());
    if (parameters.scene.is_filled_in_layers)
      if (const auto layers =
            fill_all_layers_but_last(parameters, part, log, after_load_step))
        static_stage.place_on(*layers);
    const StaticState<dim> state =
      settle(static_stage, part.scene, parameters, log, after_load_step);
    carry_to_particles(state,
                       part.scene,
                       *part.flow,
                       parameters.static_stage.displaces_particles);
    settle_particles(parameters.static_stage, part, log);
    static_scope.stop();
    if (parameters.output.writes_grid)
      {
        TimerOutput::Scope output_scope(timings, Timing::output);
        static_stage.write_vtu(parameters.output.directory);
      }
    return AtRest{static_stage.view().wall_records(), state.effort};
  }



#define INSTANTIATE(dim)                             \
  template std::optional<AtRest> find_state_at_rest( \
    const Parameters &,                              \
    Part<dim> &,                                     \
    Log &,                                           \
    TimerOutput &,                                   \
    const std::function<void()> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
