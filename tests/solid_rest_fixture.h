#ifndef sandglass_tests_solid_rest_fixture_h
#define sandglass_tests_solid_rest_fixture_h

#include <sandglass/flow/updated_lagrangian/static_stage.h>

#include <iostream>

#include "solid_fixture.h"

/// The state at rest of a mesh in space.
struct SolidRest : SolidFixture
{
  Sandglass::StaticState<3>
  run(const Sandglass::Mesh<3> &mesh)
  {
    scene = std::make_unique<Sandglass::Scene<3>>(
      mesh,
      walls,
      Sandglass::Formulation::three_dimensions,
      8,
      gravity,
      MPI_COMM_WORLD);
    dealii::ConditionalOStream log(log_text);
    Sandglass::StaticStage<3> stage(*scene, material, walls, static_stage, log);
    const auto                state = stage.run();
    std::cout << state.effort.n_unknowns << " unknowns, "
              << state.effort.n_newton_iterations << " Newton, "
              << state.effort.n_linear_iterations << " linear iterations, "
              << state.effort.n_relaxation_steps << " relaxation steps"
              << (state.effort.is_direct ? ", direct" : ", multigrid")
              << std::endl;
    return state;
  }

  unsigned int
  n_points() const
  {
    return scene->mesh.cell_type == Sandglass::CellType::tetrahedron ? 1 : 8;
  }

  Sandglass::SymmetricComponents<6>
  mean_stress(const Sandglass::StaticState<3> &state,
              const unsigned int               cell) const
  {
    Sandglass::SymmetricComponents<6> sum =
      Sandglass::SymmetricComponents<6>::Zero();
    for (unsigned int q = 0; q < n_points(); ++q)
      sum += state.cells[cell].stress[q];
    return sum / n_points();
  }

  dealii::Tensor<1, 3>
  force_of_walls(const Sandglass::StaticState<3> &state) const
  {
    dealii::Tensor<1, 3> sum;
    for (const auto &force : state.wall_forces)
      sum += force.force;
    return sum;
  }
};

#endif
