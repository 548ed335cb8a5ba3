#ifndef sandglass_run_checkpoint_writer_h
#define sandglass_run_checkpoint_writer_h

#include <sandglass/output/schedule.h>
#include <sandglass/run/part.h>

namespace Sandglass
{
  /// Writes a run's checkpoints when they are due. Throws RunError where the
  /// file can't be written.
  template <int dim>
  class CheckpointWriter
  {
  public:
    /// The arguments have to live as long as it does.
    CheckpointWriter(const OutputParameters &parameters,
                     const Fingerprint      &fingerprint,
                     TimerOutput            &timings);

    /// All times up to this one, in s, are done with.
    void
    pass(const double time);

    /// Ranks wait for each other only if a checkpoint is due.
    void
    after_step(Part<dim> &part);

    /// Write the last one, if any are asked for. Collective.
    void
    at_end(Part<dim> &part);

    /// Write one now, unless after_step() has just done so. Collective.
    void
    at_stop(Part<dim> &part);

  private:
    void
    write(Part<dim> &part);


    const OutputParameters &parameters;
    const Fingerprint      &fingerprint;
    TimerOutput            &timings;
    Schedule                times;
    double                  last_time = -1.; ///< of the last one, in s
  };
} // namespace Sandglass

#endif
