#include <deal.II/base/conditional_ostream.h>

#include <sandglass/scene/make_mesh.h>
#include <sandglass/static_stage/static_stage.h>

#include <gtest/gtest.h>

#include <sstream>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// A closed silo, 6.5 times as high as wide, in horizontal bands.
  class TallSilo
  {
  public:
    static constexpr unsigned int n_bands = 13;
    static constexpr double half_width = 0.2, height = 2.6;
    static constexpr double band_height = height / n_bands;

    TallSilo()
    {
      SceneParameters parameters;
      parameters.half_width        = half_width;
      parameters.outlet_half_width = 0.5 * half_width;
      parameters.wall_height       = height;
      parameters.element_size      = 0.04;
      parameters.outlet_is_open    = false;
      fixture.start(mesh_silo(parameters));

      std::ostringstream log_text;
      ConditionalOStream log(log_text);
      StaticStage        stage(*fixture.scene,
                        fixture.material,
                        fixture.walls,
                        static_parameters,
                        log);
      sum(stage.run());
    }

    StageFixture          fixture;
    StaticStageParameters static_parameters;

    /// Means over each band, compression positive, in Pa.
    std::array<double, n_bands> wall_pressure{}, vertical_stress{};
    double                      wall_friction = 0., floor_force = 0.; ///< N/m

  private:
    static unsigned int
    band_at(const double y)
    {
      return std::min<unsigned int>(y / band_height, n_bands - 1);
    }

    void
    sum(const StaticState &state)
    {
      std::array<double, n_bands> areas{}, wall_areas{};
      for (const auto &cell :
           fixture.scene->triangulation.active_cell_iterators())
        {
          const unsigned int band = band_at(cell->center()[1]);
          const auto &stress = state.cells[cell->active_cell_index()].stress[0];
          vertical_stress[band] -= cell->measure() * stress[Component::yy];
          areas[band] += cell->measure();
        }
      for (const WallForce &force : state.wall_forces)
        if (force.role == BoundaryRole::wall)
          {
            const unsigned int band = band_at(force.position[1]);
            wall_pressure[band] += force.normal_force;
            wall_areas[band] += force.tributary_area;
            wall_friction += force.tangential_force;
          }
        else
          floor_force += force.normal_force;
      for (unsigned int band = 0; band < n_bands; ++band)
        {
          vertical_stress[band] /= areas[band];
          wall_pressure[band] /= wall_areas[band];
        }
    }
  };
} // namespace

TEST(JanssenSilo, WallPressureAwayFromTheEnds)
{
  const TallSilo silo;
  // More than one silo width away from the top and the bottom.
  constexpr unsigned int first = 3, last = TallSilo::n_bands - 3;

  double K = 0.;
  for (unsigned int band = first; band < last; ++band)
    K += silo.wall_pressure[band] / silo.vertical_stress[band] / (last - first);

  const double weight_density = 1500. * 9.81;
  const double mu             = silo.fixture.walls.friction_coefficient();
  const double depth_scale    = 2. * TallSilo::half_width / (2. * K * mu);
  for (unsigned int band = first; band < last; ++band)
    {
      const double z =
        TallSilo::height - (band + 0.5) * TallSilo::band_height;
      const double janssen =
        weight_density * K * depth_scale * (1. - std::exp(-z / depth_scale));
      std::cout << "depth / width " << z / (2. * TallSilo::half_width)
                << ", pressure / Janssen " << silo.wall_pressure[band] / janssen
                << std::endl;
      EXPECT_NEAR(silo.wall_pressure[band] / janssen, 1., 0.05);
    }
  std::cout << "K = " << K << std::endl;
}

TEST(JanssenSilo, WallsAndFloorCarryTheWeight)
{
  const TallSilo silo;
  const double   weight =
    1500. * 9.81 * TallSilo::half_width * TallSilo::height;
  EXPECT_NEAR((silo.wall_friction + silo.floor_force) / weight, 1., 1e-8);
}
