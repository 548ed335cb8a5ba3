#include "stage_fixture.h"

#include <sandglass/material/drucker_prager.h>
#include <sandglass/walls/section_tangent.h>

#include <cmath>

#include "time_step_text.h"

using namespace Sandglass;

template class Sandglass::ParticleStage<StageLayout>;



const char *
name_of(const ForceIntegration integration)
{
  return integration == ForceIntegration::cell ? "cell" : "particles";
}



double
plastic_work(const ParticleStage<StageLayout> &stage)
{
  return stage.view().totals().dissipated_energy -
         stage.wall_contact().friction_dissipation();
}



double
discharged_mass(const FlowTotals &totals)
{
  return totals.mass_falling + totals.mass_removed;
}



double
mass_of_all(const FlowTotals &totals)
{
  return totals.mass_in_silo + discharged_mass(totals) + totals.mass_lost;
}



double
MeanWallForce::normal_force() const
{
  return -(force * normal);
}



double
MeanWallForce::tangential_force() const
{
  return force * wall_tangent(normal);
}



StageFixture::StageFixture()
{
  material.yield_cone = YieldCone::paper;
}



StageFixture::~StageFixture() = default;



StageFixture::Stage &
StageFixture::start(const Mesh<2> &mesh)
{
  stage.reset();
  parameters.check();
  scene = std::make_unique<Scene<2>>(
    mesh, walls, formulation, particles_per_cell, gravity, MPI_COMM_WORLD);
  stage.reset(&dynamic_cast<Stage &>(*make_flow(*scene).release()));
  last_records = stage->view().wall_records();
  dissipation_watcher.watch(*stage);
  return *stage;
}



std::unique_ptr<DynamicFlow<2>>
StageFixture::make_flow(const Scene<2> &of_scene)
{
  return Sandglass::make_flow<2>(
    of_scene,
    material,
    walls,
    {flow_parameters, parameters, updated_lagrangian, static_stage, feed},
    no_log);
}



Elasticity
StageFixture::elasticity() const
{
  return DruckerPrager(material).elasticity;
}



void
StageFixture::set_time_step(const double time_step)
{
  parameters.time_step_text = time_step_text(time_step);
}



BoundaryRole
StageFixture::role_of(const WallId wall) const
{
  return scene->walls[wall].role;
}



std::vector<MeanWallForce>
StageFixture::take_mean_forces()
{
  const WallRecords          records = stage->view().wall_records();
  const double               time    = records.time - last_records.time;
  std::vector<MeanWallForce> forces;
  for (unsigned int i = 0; i < records.records.size(); ++i)
    {
      const auto   &record = records.records[i];
      MeanWallForce force{};
      force.wall           = record.wall;
      force.tributary_area = record.area;
      for (unsigned int d = 0; d < 2; ++d)
        {
          force.position[d] = record.position[d];
          force.normal[d]   = record.normal[d];
          if (time > 0.)
            force.force[d] =
              (record.impulse[d] - last_records.records[i].impulse[d]) / time;
        }
      forces.push_back(force);
    }
  last_records = records;
  return forces;
}



bool
StageFixture::is_finite() const
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



void
StageFixture::DissipationWatcher::watch(Stage &stage)
{
  this->stage        = &stage;
  last               = stage.dissipation();
  stage.step_watcher = this;
}



void
StageFixture::DissipationWatcher::begin(const StepPart part)
{
  if (part != StepPart::done)
    return;
  // A stage that has settled starts anew.
  if (stage->view().clock().step == 1)
    last = 0.;
  constexpr double rounding = 1e-12;
  const double     now      = stage->dissipation();
  // What is no number the stage itself has to find.
  AssertThrow(!(now < (1. - rounding) * last),
              dealii::ExcMessage(
                describe(stage->view().clock()) +
                "dissipated energy has come back: " + std::to_string(last) +
                " J, then " + std::to_string(now)));
  last = now;
}
