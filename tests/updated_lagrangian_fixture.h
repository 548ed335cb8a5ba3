#ifndef sandglass_tests_updated_lagrangian_fixture_h
#define sandglass_tests_updated_lagrangian_fixture_h

#include <sandglass/flow/updated_lagrangian/motion/updated_lagrangian_flow.h>

#include <memory>
#include <sstream>

#include "cleared_parameters.h"
#include "rectangle_mesh.h"

/// The flow by finite elements on any mesh, with all parameters at hand before
/// start().
struct UpdatedLagrangianFixture
{
  UpdatedLagrangianFixture();
  ~UpdatedLagrangianFixture();

  ClearedParameters                      cleared;
  Sandglass::MaterialParameters          material;
  Sandglass::WallParameters              walls;
  Sandglass::StaticStageParameters       static_parameters;
  Sandglass::UpdatedLagrangianParameters parameters;

  Sandglass::Formulation formulation = Sandglass::Formulation::plane_strain;
  dealii::Tensor<1, 2>   gravity{{0., -9.81}};
  double                 end_time = 1e3;

  std::ostringstream                                log_text;
  dealii::ConditionalOStream                        log{log_text};
  std::unique_ptr<Sandglass::Scene<2>>              scene;
  std::unique_ptr<Sandglass::UpdatedLagrangianFlow> flow;

  /// Make a flow of unstressed material.
  void
  start(const Sandglass::Mesh<2> &mesh);

  /// Another one of the same scene.
  std::unique_ptr<Sandglass::UpdatedLagrangianFlow>
  make();

  /// Bring it to rest.
  void
  rest();

  /// Sum of the forces in N of a wall's parts with this normal.
  dealii::Tensor<1, 2>
  wall_force(const dealii::Tensor<1, 2> &normal) const;

  /// Of all material.
  dealii::Tensor<1, 3>
  mean_velocity() const;
};

#endif
