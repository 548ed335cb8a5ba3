#include "solid_fixture.h"

#include "time_step_text.h"

using namespace Sandglass;

template class Sandglass::ParticleStage<SolidFixture::Layout>;



SolidFixture::SolidFixture()  = default;
SolidFixture::~SolidFixture() = default;



SolidFixture::Stage &
SolidFixture::start(const Mesh<3> &mesh, const MPI_Comm communicator)
{
  stage.reset();
  parameters.check();
  scene = std::make_unique<Scene<3>>(mesh,
                                     walls,
                                     Formulation::three_dimensions,
                                     particles_per_cell,
                                     gravity,
                                     communicator);
  stage.reset(&dynamic_cast<Stage &>(
    *make_flow<3>(
       *scene,
       material,
       walls,
       {flow_parameters, parameters, updated_lagrangian, static_stage, feed},
       no_log)
       .release()));
  return *stage;
}



void
SolidFixture::set_time_step(const double time_step)
{
  parameters.time_step_text = time_step_text(time_step);
}



dealii::Tensor<1, 3>
SolidFixture::momentum() const
{
  dealii::Tensor<1, 3> sum;
  for_each_particle([&](auto, const auto &, const auto &state) {
    for (unsigned int d = 0; d < 3; ++d)
      sum[d] += state[Layout::mass] * state[Layout::velocity + d];
  });
  return sum;
}



dealii::Tensor<1, 3>
SolidFixture::angular_momentum() const
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
