#ifndef sandglass_tests_output_silo_h
#define sandglass_tests_output_silo_h

#include <sandglass/run/checkpoint_writer.h>
#include <sandglass/run/part.h>

#include <string>
#include <vector>

#include "cleared_parameters.h"

namespace Sandglass
{
  /**
   * Parameters of a small plane silo, for the tests to change. The output
   * directory is the same on the ranks of the communicator, and goes in the
   * end.
   */
  struct SmallSilo
  {
    explicit SmallSilo(const MPI_Comm     communicator = MPI_COMM_SELF,
                       const std::string &name         = "");

    ~SmallSilo();

    /// A path that no other test uses at the same time.
    static std::string
    unique_path();

    /// As a parameter file does; only for the silo that was made last.
    static void
    set(const std::string &section,
        const std::string &name,
        const std::string &value);

    const MPI_Comm communicator;

  private:
    ClearedParameters cleared;

  public:
    Parameters               parameters;
    SceneParameters         &scene;
    MaterialParameters      &material;
    WallParameters          &walls;
    ParticleStageParameters &stage;
    OutputParameters        &output;

  private:
    void
    remove_directory() const;
  };



  /// The scene and the particles of a small silo, and what observes them.
  struct SmallRun
  {
    explicit SmallRun(SmallSilo &silo);

    /// Run from the start to `end_time`, or if that is less, to the end.
    void
    run(const double end_time = 1e300, const AtRest *at_rest = nullptr);

    /// Go on from the checkpoint in the output directory to the end.
    void
    resume();

    Checkpoint
    find_checkpoint() const;

    void
    go_on_from(const Checkpoint &checkpoint);

    void
    go_on(const double end_time);

    const FlowView &
    view() const;

    SmallSilo          &silo;
    Log                 log;
    TimerOutput         timings;
    const Mesh<2>       mesh;
    const Fingerprint   fingerprint;
    CheckpointWriter<2> checkpoints;
    Part<2>             part;
    const Scene<2>     &scene;
    Observers<2>       &observers;
    DynamicFlow<2>     &flow;
  };



  std::string
  read_text(const std::string &filename);



  std::vector<std::string>
  read_lines(const std::string &filename);



  /// The numbers of one line of a table.
  std::vector<double>
  read_numbers(const std::string &line);
} // namespace Sandglass

#endif
