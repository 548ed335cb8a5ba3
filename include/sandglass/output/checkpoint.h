#ifndef sandglass_output_checkpoint_h
#define sandglass_output_checkpoint_h

#include <sandglass/flow/particle_in_cell/particle_stage.h>
#include <sandglass/walls/friction.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * All that a run needs to go on as if it had not stopped: bit by bit the same
   * on the same number of ranks with the same partitioner, up to rounding
   * otherwise.
   */
  struct Checkpoint
  {
    /// What must not change between the two parts of a run.
    struct Setting
    {
      std::string section, name, value;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &section &name &value;
      }
    };

    /// Sums that each rank keeps for itself.
    struct RankSums
    {
      double plastic_dissipation, friction_dissipation; ///< in J
      double mass_discharged, mass_lost;                ///< in kg

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &plastic_dissipation &friction_dissipation &mass_discharged
          &mass_lost;
      }
    };

    /// What a node remembers of its contact with its two supports.
    struct NodeState
    {
      /// Vertex of the triangulation, the same on any number of ranks.
      unsigned int                  vertex;
      std::array<FrictionMemory, 2> friction;
      /// See Contact::Sums.
      std::array<double, 4> impulses;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &vertex &friction &impulses;
      }
    };

    Clock  clock;
    double automatic_time_step     = 0.; ///< in s
    double last_local_eigenvalue   = 0.; ///< in 1/s^2
    double last_critical_time_step = 0.; ///< in s
    double impulse_time            = 0.; ///< of the impulses, in s

    /// The partition and how even it is, for the same order of sums.
    std::vector<unsigned int> cell_weights;
    Waiting                   waiting;

    std::vector<RankSums>  rank_sums;
    std::vector<Parcel>    particles; ///< in each cell's order
    std::vector<NodeState> nodes;

    /// What the observers need to go on, in their own words.
    std::string observers;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &clock &automatic_time_step &last_local_eigenvalue
        &last_critical_time_step           &impulse_time;
      archive &cell_weights                &waiting;
      archive &rank_sums &particles &nodes &observers;
    }
  };

  /**
   * The settings of a run that its checkpoints go with: all parameters that
   * change the motion, apart from time steps.
   */
  std::vector<Checkpoint::Setting>
  checkpoint_settings(const Scene                   &scene,
                      const MaterialParameters      &material,
                      const WallParameters          &walls,
                      const ParticleStageParameters &particle_stage);

  /// The state of the stage; complete on rank 0. Collective.
  Checkpoint
  take_checkpoint(ParticleStage &stage);

  /// Put the stage into the state of the checkpoint.
  void
  restore(const Checkpoint &checkpoint, ParticleStage &stage);

  /// Carry a stage's state over to one with another partition of the same mesh,
  /// as a checkpoint would. Collective.
  void
  hand_over(ParticleStage &from, ParticleStage &to);

  /// The checkpoint's file in an output directory.
  std::string
  checkpoint_file(const std::string &directory);

  /// Write the file in one go. On one rank. Throws RunError.
  void
  write_checkpoint(const std::string                      &directory,
                   const std::vector<Checkpoint::Setting> &settings,
                   const Checkpoint                       &checkpoint);

  /**
   * Read the file. On each rank. Throws InputError if there is none, or if it
   * was written with other settings.
   */
  Checkpoint
  read_checkpoint(const std::string                      &directory,
                  const std::vector<Checkpoint::Setting> &settings);
} // namespace Sandglass

#endif
