#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/make_flow.h>
#include <sandglass/run/flow_state.h>
#include <sandglass/run/part.h>

namespace Sandglass
{
  template <int dim>
  Part<dim>::Part(const Parameters                &parameters,
                  const Mesh<dim>                 &mesh,
                  const std::vector<bool>         &closed_faces,
                  const std::vector<unsigned int> &cell_weights,
                  const MPI_Comm                   communicator,
                  Log                             &log,
                  TimerOutput                     &timings)
    : closed_faces(closed_faces)
    , scene(mesh,
            parameters.walls,
            parameters.scene.formulation,
            parameters.scene.resolution().particles_per_cell,
            parameters.scene.gravity_vector<dim>(),
            communicator,
            parameters.scene.partitioner,
            cell_weights)
    , flow(make_flow(scene,
                     parameters.material,
                     parameters.walls,
                     {parameters.flow,
                      parameters.particle_stage,
                      parameters.updated_lagrangian,
                      parameters.static_stage,
                      parameters.feed},
                     log.stream()))
    , observers(parameters.output,
                scene,
                parameters.scene.resolution(),
                parameters.material,
                parameters.particle_stage.end_time,
                parameters.feed.kind != FeedKind::none,
                log,
                timings)
  {}



  template <int dim>
  Checkpoint
  Part<dim>::take_checkpoint()
  {
    Checkpoint checkpoint;
    checkpoint.time         = flow->view().clock().time;
    checkpoint.cell_weights = scene.cell_weights;
    checkpoint.closed_faces = closed_faces;
    checkpoint.balance      = balance;
    checkpoint.flow         = saved_state(*flow);
    checkpoint.observers    = observers.archived();
    return checkpoint;
  }



  template <int dim>
  void
  Part<dim>::go_on_from(const Checkpoint &checkpoint)
  {
    load_state(checkpoint.flow, *flow);
    balance = checkpoint.balance;
    observers.go_on_from(checkpoint.observers, flow->view());
  }



  template <int dim>
  void
  Part<dim>::go_on_from(Part &before)
  {
    hand_over(*before.flow, *flow, scene.communicator);
    observers.go_on_from(before.observers, before.flow->view(), flow->view());
  }



#define INSTANTIATE(dim) template struct Part<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
