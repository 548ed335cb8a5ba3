#ifndef sandglass_tests_solid_fixture_h
#define sandglass_tests_solid_fixture_h

#include <sandglass/flow/make_flow.h>
#include <sandglass/flow/particle_in_cell/particle_stage.h>

#include <memory>
#include <sstream>

#include "box_mesh.h"
#include "cleared_parameters.h"

// In solid_fixture.cc: to compile it takes two seconds.
extern template class Sandglass::ParticleStage<
  Sandglass::ParticleLayout<3, 6, 0>>;

/**
 * A particle stage in space on a hand-made mesh, with all parameters at hand
 * before start() makes the stage.
 */
struct SolidFixture
{
  using Layout = Sandglass::ParticleLayout<3, 6, 0>;
  using Stage  = Sandglass::ParticleStage<Layout>;

  SolidFixture();
  ~SolidFixture();

  ClearedParameters                      cleared;
  Sandglass::MaterialParameters          material;
  Sandglass::WallParameters              walls;
  Sandglass::ParticleStageParameters     parameters;
  Sandglass::FlowParameters              flow_parameters;
  Sandglass::UpdatedLagrangianParameters updated_lagrangian;
  Sandglass::StaticStageParameters       static_stage;
  Sandglass::FeedParameters              feed;
  std::ostringstream                     log_text;
  dealii::ConditionalOStream             no_log{log_text, false};

  unsigned int         particles_per_cell = 8;
  dealii::Tensor<1, 3> gravity{{0., -9.81, 0.}};

  std::unique_ptr<Sandglass::Scene<3>> scene;
  std::unique_ptr<Stage>               stage;

  Stage &
  start(const Sandglass::Mesh<3> &mesh,
        const MPI_Comm            communicator = MPI_COMM_WORLD);

  /// Give start() a fixed step in s instead of the automatic one.
  void
  set_time_step(const double time_step);

  /// Call `function(id, position, properties)` for each particle. It may change
  /// nothing.
  template <typename Function>
  void
  for_each_particle(const Function &function) const
  {
    for (const auto &particle : stage->particles().handler())
      function(particle.get_id(),
               particle.get_location(),
               dealii::ArrayView<const double>(particle.get_properties()));
  }

  /// The same for a function that changes properties.
  template <typename Function>
  void
  change_particles(const Function &function)
  {
    stage->edit_particles([&](auto &handler) {
      for (auto &particle : handler)
        function(particle.get_id(),
                 particle.get_location(),
                 particle.get_properties());
    });
  }

  /// Of all particles of this rank, in kg m/s.
  dealii::Tensor<1, 3>
  momentum() const;

  /// About the origin, in kg m^2/s.
  dealii::Tensor<1, 3>
  angular_momentum() const;
};

#endif
