#ifndef sandglass_tests_solid_fixture_h
#define sandglass_tests_solid_fixture_h

#include <sandglass/choices.h>
#include <sandglass/flow/make_flow.h>
#include <sandglass/flow/particle_in_cell/particle_stage.h>

#include <cmath>
#include <iomanip>
#include <memory>
#include <sstream>

#include "box_mesh.h"

/**
 * A particle stage in space on a hand-made mesh, with all parameters at hand
 * before start() makes the stage.
 *
 * The parameter classes add themselves to a global list; it is cleared so that
 * each test can make its own.
 */
struct SolidFixture
{
  using Layout = Sandglass::ParticleLayout<3, 6, 0>;
  using Stage  = Sandglass::ParticleStage<Layout>;

  struct ClearedParameters
  {
    ClearedParameters()
    {
      dealii::ParameterAcceptor::clear();
    }
  };

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
        const MPI_Comm            communicator = MPI_COMM_WORLD)
  {
    stage.reset();
    parameters.check();
    scene = std::make_unique<Sandglass::Scene<3>>(
      mesh,
      walls,
      Sandglass::Formulation::three_dimensions,
      particles_per_cell,
      gravity,
      communicator);
    stage.reset(&dynamic_cast<Stage &>(
      *Sandglass::make_flow<3>(
         *scene,
         material,
         walls,
         {flow_parameters, parameters, updated_lagrangian, static_stage, feed},
         no_log)
         .release()));
    return *stage;
  }

  /// Give start() a fixed step in s instead of the automatic one.
  void
  set_time_step(const double time_step)
  {
    std::ostringstream text;
    text << std::setprecision(17) << time_step;
    parameters.time_step_text = text.str();
  }

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
  momentum() const
  {
    dealii::Tensor<1, 3> sum;
    for_each_particle([&](auto, const auto &, const auto &state) {
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += state[Layout::mass] * state[Layout::velocity + d];
    });
    return sum;
  }

  /// About the origin, in kg m^2/s.
  dealii::Tensor<1, 3>
  angular_momentum() const
  {
    dealii::Tensor<1, 3> sum;
    for_each_particle([&](auto, const auto &position, const auto &state) {
      dealii::Tensor<1, 3> velocity;
      for (unsigned int d = 0; d < 3; ++d)
        velocity[d] = state[Layout::velocity + d];
      sum += state[Layout::mass] *
             dealii::cross_product_3d(dealii::Tensor<1, 3>(position), velocity);
    });
    return sum;
  }
};

#endif
