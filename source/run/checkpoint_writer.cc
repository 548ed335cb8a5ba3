#include <deal.II/base/mpi.h>

#include <sandglass/choices/dimensions.h>
#include <sandglass/output/output_directory.h>
#include <sandglass/run/checkpoint_writer.h>

namespace Sandglass
{
  template <int dim>
  CheckpointWriter<dim>::CheckpointWriter(const OutputParameters &parameters,
                                          const Fingerprint      &fingerprint,
                                          TimerOutput            &timings)
    : parameters(parameters)
    , fingerprint(fingerprint)
    , timings(timings)
    , times(parameters.checkpoint_interval)
  {}



  template <int dim>
  void
  CheckpointWriter<dim>::pass(const double time)
  {
    times.pass(time);
    last_time = time;
  }



  template <int dim>
  void
  CheckpointWriter<dim>::after_step(Part<dim> &part)
  {
    if (times.is_due(part.flow->view().clock().time))
      write(part);
  }



  template <int dim>
  void
  CheckpointWriter<dim>::at_end(Part<dim> &part)
  {
    if (parameters.checkpoint_interval > 0.)
      write(part);
  }



  template <int dim>
  void
  CheckpointWriter<dim>::at_stop(Part<dim> &part)
  {
    if (part.flow->view().clock().time != last_time)
      write(part);
  }



  template <int dim>
  void
  CheckpointWriter<dim>::write(Part<dim> &part)
  {
    TimerOutput::Scope scope(timings, Timing::output);
    const MPI_Comm     communicator = part.scene.communicator;
    const Checkpoint   checkpoint   = part.take_checkpoint();
    pass(checkpoint.time);
    do_and_share_errors(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        write_checkpoint(parameters.directory, fingerprint, checkpoint);
    });
  }



#define INSTANTIATE(dim) template class CheckpointWriter<dim>;

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
