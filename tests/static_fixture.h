#ifndef sandglass_tests_static_fixture_h
#define sandglass_tests_static_fixture_h

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

#include <sandglass/flow/updated_lagrangian/static_stage.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/walls/section_tangent.h>

#include <memory>
#include <sstream>

#include "rectangle_mesh.h"

/**
 * The static stage on any mesh, with all parameters at hand before run().
 *
 * The parameter classes add themselves to a global list; it is cleared so that
 * each test can make its own.
 */
struct StaticFixture
{
  struct ClearedParameters
  {
    ClearedParameters()
    {
      dealii::ParameterAcceptor::clear();
    }
  };

  StaticFixture()
  {
    material.yield_cone = Sandglass::YieldCone::paper;
  }

  ClearedParameters                cleared;
  Sandglass::SceneParameters       silo; ///< for run_silo()
  Sandglass::MaterialParameters    material;
  Sandglass::WallParameters        walls;
  Sandglass::StaticStageParameters parameters;

  Sandglass::Formulation formulation = Sandglass::Formulation::plane_strain;
  dealii::Tensor<1, 2>   gravity{{0., -9.81}};

  std::unique_ptr<Sandglass::Scene<2>> scene;
  Sandglass::StaticState<2>            state;
  std::ostringstream                   log_text;

  void
  run(const Sandglass::Mesh<2> &mesh,
      const MPI_Comm            communicator = MPI_COMM_WORLD)
  {
    scene = std::make_unique<Sandglass::Scene<2>>(
      mesh, walls, formulation, 4, gravity, communicator);
    dealii::ConditionalOStream log(log_text);
    Sandglass::StaticStage<2>  stage(*scene, material, walls, parameters, log);
    state = stage.run();
  }

  void
  run_silo()
  {
    run(Sandglass::mesh_silo<2>(silo));
  }

  Sandglass::Elasticity
  elasticity() const
  {
    return Sandglass::DruckerPrager(material).elasticity;
  }

  unsigned int
  n_points() const
  {
    return scene->mesh.cell_type == Sandglass::CellType::triangle ? 1 : 4;
  }

  Sandglass::BoundaryRole
  role_of(const Sandglass::WallId wall) const
  {
    return scene->walls[wall].role;
  }

  dealii::Point<2>
  position_of(const Sandglass::WallForce<2> &force) const
  {
    return scene->mesh.vertices[force.vertex];
  }

  /// In N, along wall_tangent(): upwards, or to the right on floors.
  static double
  tangential_force(const Sandglass::WallForce<2> &force)
  {
    return force.force * Sandglass::wall_tangent(force.normal);
  }

  /// Call `function(cell, cell_state)` for each filled cell.
  template <typename Function>
  void
  for_each_cell(const Function &function) const
  {
    for (const auto &cell : scene->triangulation.active_cell_iterators())
      if (scene->mesh.cells[cell->active_cell_index()].is_filled)
        function(cell, state.cells[cell->active_cell_index()]);
  }

  /// Mean over the cell's quadrature points.
  Sandglass::SymmetricComponents<4>
  mean_stress(const Sandglass::StaticState<2>::CellState &cell_state) const
  {
    Sandglass::SymmetricComponents<4> sum =
      Sandglass::SymmetricComponents<4>::Zero();
    for (unsigned int q = 0; q < n_points(); ++q)
      sum += cell_state.stress[q];
    return sum / n_points();
  }

  /// Weight of the material, its mass integrated as by the static stage. In N,
  /// or N per metre of depth.
  double
  weight() const
  {
    dealii::Quadrature<2> quadrature = dealii::QGaussSimplex<2>(1);
    if (scene->mesh.cell_type == Sandglass::CellType::quadrilateral)
      quadrature = dealii::QIterated<2>(dealii::QMidpoint<1>(), 2);
    dealii::FEValues<2> fe_values(scene->mapping,
                                  *scene->finite_element,
                                  quadrature,
                                  dealii::update_quadrature_points |
                                    dealii::update_JxW_values);
    const bool          is_axisymmetric =
      formulation == Sandglass::Formulation::axisymmetric;
    double volume = 0.;
    for_each_cell([&](const auto &cell, const auto &) {
      fe_values.reinit(cell);
      for (const unsigned int q : fe_values.quadrature_point_indices())
        volume += fe_values.JxW(q) * (is_axisymmetric ?
                                        2. * dealii::numbers::PI *
                                          fe_values.quadrature_point(q)[0] :
                                        1.);
    });
    return -gravity[1] * material.density * volume;
  }

  /// Upward force of all walls on the material, in N.
  double
  lift() const
  {
    double sum = 0.;
    for (const auto &force : state.wall_forces)
      sum += force.force[1];
    return sum;
  }
};

#endif
