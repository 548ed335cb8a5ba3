#include <sandglass/scene/make_mesh.h>

#include <gtest/gtest.h>

#include <cmath>

#include "rest.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr unsigned int n_bands = 8;

  /// Volume averages of the stress in horizontal bands of equal height.
  using BandStress = std::array<SymmetricComponents<4>, n_bands>;

  /// A closed flat-bottomed silo, brought to rest by the static stage.
  class ClosedSilo
  {
  public:
    explicit ClosedSilo(const CellType cell_type)
    {
      scene_parameters.element_size   = 0.05;
      scene_parameters.cell_type      = cell_type;
      scene_parameters.outlet_is_open = false;
      fixture.parameters.end_time     = 2.;
      fixture.start(mesh_silo<2>(scene_parameters));

      start_from_rest(fixture);
    }

    BandStress
    band_stress() const
    {
      const double                top = scene_parameters.wall_height;
      BandStress                  sums;
      std::array<double, n_bands> volumes{};
      sums.fill(SymmetricComponents<4>::Zero());
      fixture.for_each_particle([&](auto id, auto &, auto state) {
        const double y = fixture.stage->initial_position(id)[1];
        const auto   band =
          std::min<unsigned int>(n_bands * y / top, n_bands - 1);
        const double volume =
          state[StageLayout::mass] / state[StageLayout::density];
        volumes[band] += volume;
        sums[band] += volume * Eigen::Map<const SymmetricComponents<4>>(
                                 &state[StageLayout::stress]);
      });
      for (unsigned int band = 0; band < n_bands; ++band)
        sums[band] /= volumes[band];
      return sums;
    }

    /// Kinetic energy over m g H.
    double
    relative_kinetic_energy() const
    {
      double mass = 0., energy = 0.;
      fixture.for_each_particle([&](auto, auto &, auto state) {
        mass += state[StageLayout::mass];
        energy +=
          0.5 * state[StageLayout::mass] *
          (state[StageLayout::velocity] * state[StageLayout::velocity] +
           state[StageLayout::velocity + 1] * state[StageLayout::velocity + 1]);
      });
      return energy / (mass * 9.81 * scene_parameters.wall_height);
    }

    StageFixture    fixture;
    SceneParameters scene_parameters;
  };

  class ClosedSiloTest : public testing::TestWithParam<CellType>
  {};
} // namespace

TEST_P(ClosedSiloTest, StaysAtRest)
{
  ClosedSilo       silo(GetParam());
  const BandStress before         = silo.band_stress();
  double           largest_energy = 0.;
  while (!silo.fixture.stage->is_finished())
    {
      silo.fixture.stage->step();
      largest_energy = std::max(largest_energy, silo.relative_kinetic_energy());
    }
  const BandStress after = silo.band_stress();

  const double scale = 1500. * 9.81 * silo.scene_parameters.wall_height;
  double       largest_change = 0.;
  for (unsigned int band = 0; band < n_bands; ++band)
    for (unsigned int c = 0; c < 4; ++c)
      largest_change =
        std::max(largest_change,
                 std::abs(after[band][c] - before[band][c]) / scale);
  std::cout << "largest change of stress / (rho g H)     " << largest_change
            << "\nlargest kinetic energy / (m g H)         " << largest_energy
            << "\nkinetic energy at the end / (m g H)      "
            << silo.relative_kinetic_energy() << std::endl;
  EXPECT_LT(largest_change, 0.02);
  EXPECT_LT(largest_energy, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         ClosedSiloTest,
                         testing::Values(CellType::triangle,
                                         CellType::quadrilateral));
