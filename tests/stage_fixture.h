#ifndef sandglass_tests_stage_fixture_h
#define sandglass_tests_stage_fixture_h

#include <sandglass/flow/particle_in_cell/particle_stage.h>

#include <cmath>
#include <iomanip>
#include <memory>
#include <sstream>

#include "rectangle_mesh.h"

/// As in the parameter file.
inline const char *
name_of(const Sandglass::ForceIntegration integration)
{
  return integration == Sandglass::ForceIntegration::cell ? "cell" :
                                                            "particles";
}



/**
 * A particle stage on a hand-made mesh, with all parameters at hand before
 * start() makes the stage.
 *
 * The parameter classes add themselves to a global list; it is cleared so that
 * each test can make its own.
 */
struct StageFixture
{
  struct ClearedParameters
  {
    ClearedParameters()
    {
      dealii::ParameterAcceptor::clear();
    }
  };

  ClearedParameters                  cleared;
  Sandglass::MaterialParameters      material;
  Sandglass::WallParameters          walls;
  Sandglass::ParticleStageParameters parameters;

  Sandglass::Formulation formulation = Sandglass::Formulation::plane_strain;
  unsigned int           particles_per_cell = 4;
  dealii::Tensor<1, 2>   gravity{{0., -9.81}};

  std::unique_ptr<Sandglass::Scene>         scene;
  std::unique_ptr<Sandglass::ParticleStage> stage;

  Sandglass::ParticleStage &
  start(const Sandglass::Mesh &mesh)
  {
    stage.reset();
    parameters.check();
    scene = std::make_unique<Sandglass::Scene>(
      mesh, formulation, particles_per_cell, gravity, MPI_COMM_WORLD);
    stage = Sandglass::make_particle_stage(*scene, material, walls, parameters);
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

  /// Make v^L that of a function of the position, in m/s.
  template <typename Function>
  void
  set_mapped_velocity(const Function &velocity)
  {
    for_each_node(
      [&](const dealii::Point<2> &position, const unsigned int node) {
        const dealii::Tensor<1, 2> value = velocity(position);
        for (unsigned int d = 0; d < 2; ++d)
          stage->fields.mapped_velocity.at(node)[d] = value[d];
      });
  }

  /// Call `function(id, position, properties)` for each particle.
  template <typename Function>
  void
  for_each_particle(const Function &function) const
  {
    stage->cloud.edit([&](auto &handler) {
      for (auto &particle : handler)
        function(particle.get_id(),
                 particle.get_location(),
                 particle.get_properties());
    });
  }

  /// Whether all that particles carry is a number.
  bool
  is_finite() const
  {
    bool result = true;
    for_each_particle([&](auto, const auto &position, auto state) {
      double sum = position[0] + position[1];
      for (const double value : state)
        sum += value;
      result = result && std::isfinite(sum);
    });
    return result;
  }
};

#endif
