#include <gtest/gtest.h>

#include <vector>

#include "small_silo.h"

using namespace Sandglass;

namespace
{
  struct Material
  {
    double young_modulus       = 1e6;
    double poisson_ratio       = 0.3;
    double friction_angle      = 25.;
    double wall_friction_angle = 20.;
  };

  void
  PrintTo(const Material &material, std::ostream *out)
  {
    *out << "E " << material.young_modulus << " Pa, nu "
         << material.poisson_ratio << ", phi " << material.friction_angle
         << ", phi_w " << material.wall_friction_angle;
  }

  std::vector<Material>
  materials()
  {
    std::vector<Material> result;
    for (const double young_modulus : {1e5, 1e7, 1e8})
      result.push_back({young_modulus, 0.3, 25., 20.});
    for (const double poisson_ratio : {0., 0.2, 0.45, 0.49})
      result.push_back({1e6, poisson_ratio, 25., 20.});
    for (const double friction_angle : {5., 15., 35., 45.})
      for (const double wall_share : {0., 0.5, 1.})
        result.push_back(
          {1e6, 0.3, friction_angle, wall_share * friction_angle});
    for (const double young_modulus : {1e5, 1e9})
      for (const double poisson_ratio : {0., 0.49})
        for (const double friction_angle : {5., 45.})
          for (const double wall_share : {0., 1.})
            result.push_back({young_modulus,
                              poisson_ratio,
                              friction_angle,
                              wall_share * friction_angle});
    return result;
  }

  class MaterialRange
    : public testing::TestWithParam<std::tuple<CellType, Material>>
  {};
} // namespace



// At four times the time step most of these throw particles out.
TEST_P(MaterialRange, ASmallSiloComesToRestAndFlows)
{
  const Material material = std::get<1>(GetParam());
  SmallSilo      silo;
  silo.scene.cell_type                          = std::get<0>(GetParam());
  silo.fixture.material.young_modulus           = material.young_modulus;
  silo.fixture.material.poisson_ratio           = material.poisson_ratio;
  silo.fixture.material.internal_friction_angle = material.friction_angle;
  silo.fixture.walls.friction_angle             = material.wall_friction_angle;
  silo.start();
  silo.expect_sound_flow_until(0.4);
  EXPECT_GT(silo.discharged_share(), 0.05);
}

INSTANTIATE_TEST_SUITE_P(
  Materials,
  MaterialRange,
  testing::Combine(testing::Values(CellType::triangle, CellType::quadrilateral),
                   testing::ValuesIn(materials())));
