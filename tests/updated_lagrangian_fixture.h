#ifndef sandglass_tests_updated_lagrangian_fixture_h
#define sandglass_tests_updated_lagrangian_fixture_h

#include <sandglass/flow/updated_lagrangian/motion/updated_lagrangian_flow.h>
#include <sandglass/flow/updated_lagrangian/static_stage.h>
#include <sandglass/run/static_to_particles.h>

#include <memory>
#include <sstream>

#include "rectangle_mesh.h"

/// The flow by finite elements on any mesh, with all parameters at hand before
/// start().
struct UpdatedLagrangianFixture
{
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
  start(const Sandglass::Mesh<2> &mesh)
  {
    scene = std::make_unique<Sandglass::Scene<2>>(
      mesh, walls, formulation, 4, gravity, MPI_COMM_SELF);
    flow = make();
  }

  /// Another one of the same scene.
  std::unique_ptr<Sandglass::UpdatedLagrangianFlow>
  make()
  {
    return std::make_unique<Sandglass::UpdatedLagrangianFlow>(
      *scene, material, walls, parameters, static_parameters, end_time, log);
  }

  /// Bring it to rest.
  void
  rest()
  {
    Sandglass::StaticStage<2> stage(*scene,
                                    material,
                                    walls,
                                    static_parameters,
                                    log,
                                    parameters.element_order);
    Sandglass::carry_to_particles(stage.run(), *scene, *flow, true);
  }

  /// Sum of the forces in N of a wall's parts with this normal.
  dealii::Tensor<1, 2>
  wall_force(const dealii::Tensor<1, 2> &normal) const
  {
    dealii::Tensor<1, 2> sum;
    const auto           rigid = Sandglass::find_rigid_walls(*scene);
    for (const auto &contact : flow->moving_body()->contact.contacts())
      if (rigid[contact.wall].normal * normal > 0.999)
        sum += -contact.normal_force * rigid[contact.wall].normal +
               contact.tangential_force * rigid[contact.wall].tangent;
    return sum;
  }

  /// Of all material.
  dealii::Tensor<1, 3>
  mean_velocity() const
  {
    const auto totals = flow->view().totals();
    return totals.momentum / (totals.mass_in_silo + totals.mass_falling);
  }
};

#endif
