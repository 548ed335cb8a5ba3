#ifndef sandglass_tests_stage_fixture_h
#define sandglass_tests_stage_fixture_h

#include <sandglass/flow/make_flow.h>
#include <sandglass/flow/particle_in_cell/particle_stage.h>
#include <sandglass/material/elasticity.h>

#include <memory>
#include <sstream>

#include "cleared_parameters.h"
#include "rectangle_mesh.h"

/// The name in the parameter file.
const char *
name_of(const Sandglass::ForceIntegration integration);



/// What a particle carries with a law without state variables.
using StageLayout = Sandglass::ParticleLayout<2, 4, 0>;

// In stage_fixture.cc: to compile it takes two seconds.
extern template class Sandglass::ParticleStage<StageLayout>;

/// Since the start, in J; on one rank.
double
plastic_work(const Sandglass::ParticleStage<StageLayout> &stage);

/// All that has passed the outlet level, in kg.
double
discharged_mass(const Sandglass::FlowTotals &totals);

/// All that there was at the start, in kg.
double
mass_of_all(const Sandglass::FlowTotals &totals);

/// Mean over some time of a wall's force on the material at one node.
struct MeanWallForce
{
  dealii::Point<2>     position;
  Sandglass::WallId    wall;
  dealii::Tensor<1, 2> normal; ///< outward from the material
  double               tributary_area;
  dealii::Tensor<1, 2> force; ///< in N

  /// Compression positive.
  double
  normal_force() const;

  /// Along wall_tangent(normal).
  double
  tangential_force() const;
};

/**
 * A particle stage on a hand-made mesh, with all parameters at hand before
 * start() makes the stage.
 */
struct StageFixture
{
  using Stage = Sandglass::ParticleStage<StageLayout>;

  StageFixture();
  ~StageFixture();

  ClearedParameters                  cleared;
  Sandglass::MaterialParameters      material;
  Sandglass::WallParameters          walls;
  Sandglass::ParticleStageParameters parameters;

  // Of the choice of a flow; the particle stage needs none of them.
  Sandglass::FlowParameters              flow_parameters;
  Sandglass::UpdatedLagrangianParameters updated_lagrangian;
  Sandglass::StaticStageParameters       static_stage;
  Sandglass::FeedParameters              feed;
  std::ostringstream                     log_text;
  dealii::ConditionalOStream             no_log{log_text, false};

  Sandglass::Formulation formulation = Sandglass::Formulation::plane_strain;
  unsigned int           particles_per_cell = 4;
  dealii::Tensor<1, 2>   gravity{{0., -9.81}};

  std::unique_ptr<Sandglass::Scene<2>> scene;
  std::unique_ptr<Stage>               stage;

  Stage &
  start(const Sandglass::Mesh<2> &mesh);

  /// The particle stage of a scene, with what the fixture has.
  std::unique_ptr<Sandglass::DynamicFlow<2>>
  make_flow(const Sandglass::Scene<2> &of_scene);

  Sandglass::Elasticity
  elasticity() const;

  /// Give start() a fixed step in s instead of the automatic one.
  void
  set_time_step(const double time_step);

  /// Call `function(position, index in the nodal fields)` for each cell's
  /// nodes.
  template <typename Function>
  void
  for_each_node(const Function &function) const
  {
    for (const auto &cell : scene->dof_handler.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        function(cell->vertex(v),
                 scene->nodes->global_to_local(cell->vertex_dof_index(v, 0)));
  }

  /// A function of the position at the nodes.
  template <typename Function>
  Sandglass::NodalField<2>
  at_nodes(const Function &function) const
  {
    Sandglass::NodalField<2> field(*scene->nodes);
    for_each_node(
      [&](const dealii::Point<2> &position, const unsigned int node) {
        const dealii::Tensor<1, 2> value = function(position);
        for (unsigned int d = 0; d < 2; ++d)
          field.at(node)[d] = value[d];
      });
    return field;
  }

  /// Call `function(id, position, properties)` for each particle. It may change
  /// nothing: the stage goes on with the sums that its steps have left.
  template <typename Function>
  void
  for_each_particle(const Function &function) const
  {
    for (const auto &particle : stage->particles().handler())
      function(particle.get_id(),
               particle.get_location(),
               dealii::ArrayView<const double>(particle.get_properties()));
  }

  /// The same for a function that changes properties, after which the stage
  /// sums over all particles anew.
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

  Sandglass::BoundaryRole
  role_of(const Sandglass::WallId wall) const;

  /// Mean forces of the walls since the last call, or the start;
  /// zero if no time has passed.
  std::vector<MeanWallForce>
  take_mean_forces();

  /// Whether all that particles carry is a number.
  bool
  is_finite() const;

private:
  /// Fails the test when dissipated energy comes back in a step.
  class DissipationWatcher : public Sandglass::StepWatcher
  {
  public:
    void
    watch(Stage &stage);

    void
    begin(const Sandglass::StepPart part) override;

  private:
    const Stage *stage = nullptr;
    double       last  = 0.;
  };

  DissipationWatcher     dissipation_watcher;
  Sandglass::WallRecords last_records;
};

#endif
