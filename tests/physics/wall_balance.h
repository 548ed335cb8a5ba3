#ifndef sandglass_tests_physics_wall_balance_h
#define sandglass_tests_physics_wall_balance_h

#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include "rest.h"
#include "stage_fixture.h"

/// A silo that has just begun to flow, of either kind.
class BeginningFlow : public testing::TestWithParam<
                        std::tuple<Sandglass::CellType,
                                   Sandglass::Formulation,
                                   double,
                                   bool,
                                   Sandglass::WallParameters::OutletLip>>
{
protected:
  BeginningFlow()
  {
    silo.cell_type           = std::get<0>(GetParam());
    fixture.formulation      = std::get<1>(GetParam());
    silo.hopper_height       = std::get<2>(GetParam());
    silo.is_symmetric        = std::get<3>(GetParam());
    fixture.walls.outlet_lip = std::get<4>(GetParam());
    silo.wall_height         = 1.7 - silo.hopper_height / 2.;
    silo.element_size        = 0.1;
    if (!silo.is_symmetric)
      silo.outlet_eccentricity = 0.3;
    fixture.start(Sandglass::mesh_silo<2>(silo));

    start_from_rest(fixture);
    run(0.05);
    fixture.take_mean_forces();
  }

  void
  run(const double duration)
  {
    const double end = fixture.stage->view().clock().time + duration;
    while (fixture.stage->view().clock().time < end)
      fixture.stage->step();
  }

  StageFixture               fixture;
  Sandglass::SceneParameters silo;
};

/// Instantiate a test suite that is a BeginningFlow.
#define SANDGLASS_FOR_BEGINNING_FLOWS(Suite)                         \
  INSTANTIATE_TEST_SUITE_P(                                          \
    Halves,                                                          \
    Suite,                                                           \
    testing::Combine(                                                \
      testing::Values(Sandglass::CellType::triangle,                 \
                      Sandglass::CellType::quadrilateral),           \
      testing::Values(Sandglass::Formulation::plane_strain,          \
                      Sandglass::Formulation::axisymmetric),         \
      testing::Values(0., 1.1),                                      \
      testing::Values(true),                                         \
      testing::Values(Sandglass::WallParameters::OutletLip::floor,   \
                      Sandglass::WallParameters::OutletLip::free))); \
  INSTANTIATE_TEST_SUITE_P(                                          \
    Wholes,                                                          \
    Suite,                                                           \
    testing::Combine(                                                \
      testing::Values(Sandglass::CellType::triangle,                 \
                      Sandglass::CellType::quadrilateral),           \
      testing::Values(Sandglass::Formulation::plane_strain),         \
      testing::Values(0., 1.1),                                      \
      testing::Values(false),                                        \
      testing::Values(Sandglass::WallParameters::OutletLip::floor,   \
                      Sandglass::WallParameters::OutletLip::free)))

#endif
