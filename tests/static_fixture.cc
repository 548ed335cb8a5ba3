#include "static_fixture.h"

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <sandglass/material/drucker_prager.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/walls/section_tangent.h>

using namespace Sandglass;

StaticFixture::StaticFixture()
{
  material.yield_cone = YieldCone::paper;
}



StaticFixture::~StaticFixture() = default;



void
StaticFixture::run(const Mesh<2> &mesh, const MPI_Comm communicator)
{
  scene = std::make_unique<Scene<2>>(
    mesh, walls, formulation, 4, gravity, communicator);
  dealii::ConditionalOStream log(log_text);
  StaticStage<2>             stage(*scene, material, walls, parameters, log);
  state = stage.run();
}



void
StaticFixture::run_silo()
{
  run(mesh_silo<2>(silo));
}



Elasticity
StaticFixture::elasticity() const
{
  return DruckerPrager(material).elasticity;
}



unsigned int
StaticFixture::n_points() const
{
  return scene->mesh.cell_type == CellType::triangle ? 1 : 4;
}



BoundaryRole
StaticFixture::role_of(const WallId wall) const
{
  return scene->walls[wall].role;
}



dealii::Point<2>
StaticFixture::position_of(const WallForce<2> &force) const
{
  return scene->mesh.vertices[force.vertex];
}



double
StaticFixture::tangential_force(const WallForce<2> &force)
{
  return force.force * wall_tangent(force.normal);
}



SymmetricComponents<4>
StaticFixture::mean_stress(const StaticState<2>::CellState &cell_state) const
{
  SymmetricComponents<4> sum = SymmetricComponents<4>::Zero();
  for (unsigned int q = 0; q < n_points(); ++q)
    sum += cell_state.stress[q];
  return sum / n_points();
}



double
StaticFixture::weight() const
{
  dealii::Quadrature<2> quadrature = dealii::QGaussSimplex<2>(1);
  if (scene->mesh.cell_type == CellType::quadrilateral)
    quadrature = dealii::QIterated<2>(dealii::QMidpoint<1>(), 2);
  dealii::FEValues<2> fe_values(scene->mapping,
                                *scene->finite_element,
                                quadrature,
                                dealii::update_quadrature_points |
                                  dealii::update_JxW_values);
  const bool is_axisymmetric = formulation == Formulation::axisymmetric;
  double     volume          = 0.;
  for_each_cell([&](const auto &cell, const auto &) {
    fe_values.reinit(cell);
    for (const unsigned int q : fe_values.quadrature_point_indices())
      volume += fe_values.JxW(q) *
                (is_axisymmetric ?
                   2. * dealii::numbers::PI * fe_values.quadrature_point(q)[0] :
                   1.);
  });
  return -gravity[1] * material.density * volume;
}



double
StaticFixture::lift() const
{
  double sum = 0.;
  for (const auto &force : state.wall_forces)
    sum += force.force[1];
  return sum;
}
