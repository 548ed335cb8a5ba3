#ifndef sandglass_tests_static_fixture_h
#define sandglass_tests_static_fixture_h

#include <sandglass/flow/updated_lagrangian/static_stage.h>
#include <sandglass/material/elasticity.h>
#include <sandglass/scene/scene_parameters.h>

#include <memory>
#include <sstream>

#include "cleared_parameters.h"
#include "rectangle_mesh.h"

/**
 * The static stage on any mesh, with all parameters at hand before run().
 */
struct StaticFixture
{
  StaticFixture();
  ~StaticFixture();

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
      const MPI_Comm            communicator = MPI_COMM_WORLD);

  void
  run_silo();

  Sandglass::Elasticity
  elasticity() const;

  unsigned int
  n_points() const;

  Sandglass::BoundaryRole
  role_of(const Sandglass::WallId wall) const;

  dealii::Point<2>
  position_of(const Sandglass::WallForce<2> &force) const;

  /// In N, along wall_tangent(): upwards, or to the right on floors.
  static double
  tangential_force(const Sandglass::WallForce<2> &force);

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
  mean_stress(const Sandglass::StaticState<2>::CellState &cell_state) const;

  /// Weight of the material, its mass integrated as by the static stage. In N,
  /// or N per metre of depth.
  double
  weight() const;

  /// Upward force of all walls on the material, in N.
  double
  lift() const;
};

#endif
