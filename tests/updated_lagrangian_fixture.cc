#include "updated_lagrangian_fixture.h"

#include <sandglass/flow/updated_lagrangian/static_stage.h>
#include <sandglass/run/static_to_particles.h>

using namespace Sandglass;

UpdatedLagrangianFixture::UpdatedLagrangianFixture()  = default;
UpdatedLagrangianFixture::~UpdatedLagrangianFixture() = default;



void
UpdatedLagrangianFixture::start(const Mesh<2> &mesh)
{
  scene = std::make_unique<Scene<2>>(
    mesh, walls, formulation, 4, gravity, MPI_COMM_SELF);
  flow = make();
}



std::unique_ptr<UpdatedLagrangianFlow>
UpdatedLagrangianFixture::make()
{
  return std::make_unique<UpdatedLagrangianFlow>(
    *scene, material, walls, parameters, static_parameters, end_time, log);
}



void
UpdatedLagrangianFixture::rest()
{
  StaticStage<2> stage(
    *scene, material, walls, static_parameters, log, parameters.element_order);
  carry_to_particles(stage.run(), *scene, *flow, true);
}



dealii::Tensor<1, 2>
UpdatedLagrangianFixture::wall_force(const dealii::Tensor<1, 2> &normal) const
{
  dealii::Tensor<1, 2> sum;
  const auto           rigid = find_rigid_walls(*scene);
  for (const auto &contact : flow->moving_body()->contact.contacts())
    if (rigid[contact.wall].normal * normal > 0.999)
      sum += -contact.normal_force * rigid[contact.wall].normal +
             contact.tangential_force * rigid[contact.wall].tangent;
  return sum;
}



dealii::Tensor<1, 3>
UpdatedLagrangianFixture::mean_velocity() const
{
  const auto totals = flow->view().totals();
  return totals.momentum / (totals.mass_in_silo + totals.mass_falling);
}
