#include <sandglass/continuum/axisymmetric.h>
#include <sandglass/flow/particle_in_cell/particle_pass.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include <cmath>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  // The field v_r = a r, v_z = b z and a step in which the strains are small
  // enough for the stress to stay elastic.
  constexpr double a = 0.1, b = -0.15, time_step = 1e-3;
  constexpr double width = 0.25; // of a cell

  const SymmetricComponents<4> stress_before(-3e3, -5e3, -2e3, 0.);

  /// Typed by the cell type, since the motion is a template.
  template <typename CellTypeConstant>
  class AxisymmetricKinematics : public testing::Test
  {
  protected:
    static constexpr CellType cell_type = CellTypeConstant::value;
    using CellSetting                   = Setting<Axisymmetric, cell_type>;

    AxisymmetricKinematics()
    {
      fixture.formulation        = Formulation::axisymmetric;
      fixture.particles_per_cell = 9;
      Rectangle rectangle;
      rectangle.cell_type = cell_type;
      rectangle.displaced = [](const Point<2> &p) {
        return p + 0.05 * Tensor<1, 2>({std::sin(17. * p[0] + 5. * p[1]),
                                        std::cos(11. * p[0] - 7. * p[1])});
      };
      fixture.start(rectangle.mesh());
      fixture.change_particles([](auto, auto &, auto state) {
        std::copy_n(stress_before.data(),
                    4,
                    state.begin() + StageLayout::stress);
      });
    }

    /// Put each cell's first particle at `distance` cells from the axis, if
    /// the cell has an edge on it.
    void
    move_to_axis(const double distance)
    {
      const CellGeometry<cell_type> geometry(*fixture.scene);
      auto                         &stage = *fixture.stage;
      stage.edit_particles([&](auto &handler) {
        for (const auto &cell : stage.particles().owned_cells())
          for (const unsigned int face : cell->face_indices())
            if (cell->at_boundary(face) && cell->face(face)->boundary_id() ==
                                             boundary_id(BoundaryRole::axis))
              {
                auto particle = handler.particles_in_cell(cell).begin();
                const Point<2> location(distance * width,
                                        cell->face(face)->center()[1]);
                particle->set_location(location);
                particle->set_reference_location(
                  geometry.shape(cell->active_cell_index())
                    .to_reference(location));
              }
      });
    }

    void
    set_velocity_and_move()
    {
      const NodalField<2> velocity =
        fixture.at_nodes([](const Point<2> &position) {
          return Tensor<1, 2>({a * position[0], b * position[1]});
        });
      // The average of a uniform rate is that rate.
      const CellGeometry<cell_type>  geometry(*fixture.scene);
      VolumetricAverage<CellSetting> average(*fixture.scene->nodes,
                                             geometry,
                                             0.,
                                             true);
      fixture.parameters.density_update = DensityUpdate::paper;
      const StressUpdate<DruckerPrager> update(DruckerPrager(fixture.material),
                                               fixture.material.density,
                                               fixture.parameters);
      NodalSums<CellSetting>            sums(geometry, 0., {});
      sums.cells.compute(fixture.stage->particles().blocks());
      average.cells->compute(fixture.stage->particles().blocks());
      average.compute(fixture.stage->particles().blocks(), sums, velocity);
      Strays<StageLayout> strays;
      fixture.stage->edit_blocks([&](auto &blocks) {
        ParticlePass<CellSetting, DruckerPrager, true>(
          geometry, update, StressIntegration::start_of_step, 0., time_step)
          .run(blocks,
               fixture.stage->nodal_fields().acceleration, // none yet
               velocity,
               sums,
               average,
               strays);
      });
    }

    /**
     * Stress and density follow from the rates (a, b, a) and no spin, which
     * would turn the normal stresses into shear. The hoop rate v_r / r has the
     * rounding error of the reference coordinates, 1e-16, times cell over r.
     */
    void
    expect_exact_rates(const double distance) const
    {
      const Elasticity             elasticity = fixture.elasticity();
      const SymmetricComponents<4> rates(a, b, a, 0.);
      const SymmetricComponents<4> change =
        elasticity.stress(SymmetricComponents<4>(time_step * rates));
      const double ratio =
        (1. + time_step * a) * (1. + time_step * b) * (1. + time_step * a);
      const double bound = 1e-11 + 1e-14 / distance;

      double largest = 0., largest_density = 0., smallest_radius = 1e300;
      fixture.for_each_particle([&](auto, const auto &position, auto state) {
        const Eigen::Map<const SymmetricComponents<4>> stress(
          &state[StageLayout::stress]);
        smallest_radius = std::min(smallest_radius, position[0]);
        largest         = std::max(
          largest,
          (stress - stress_before - change).template lpNorm<Eigen::Infinity>() /
            change.norm());
        largest_density =
          std::max(largest_density,
                   std::abs(state[StageLayout::density] * ratio / 1500. - 1.));
        EXPECT_TRUE(std::isfinite(stress.sum()));
      });
      std::cout << "nearest to the axis, in cells " << smallest_radius / width
                << "\nlargest error of the rates      " << largest
                << "\nlargest error of the density    " << largest_density
                << std::endl;
      EXPECT_LT(largest, bound);
      EXPECT_LT(largest_density, bound * time_step);
    }

    StageFixture fixture;
  };

  using CellTypes =
    testing::Types<std::integral_constant<CellType, CellType::triangle>,
                   std::integral_constant<CellType, CellType::quadrilateral>>;

  TYPED_TEST_SUITE(AxisymmetricKinematics, CellTypes);
} // namespace



TYPED_TEST(AxisymmetricKinematics, ExpansionHasItsRatesAndNoSpin)
{
  std::map<types::particle_index, Point<2>> before;
  this->fixture.for_each_particle(
    [&](auto id, const auto &position, auto) { before[id] = position; });
  this->set_velocity_and_move();
  this->expect_exact_rates(0.1);

  double largest = 0.;
  this->fixture.for_each_particle([&](auto id, const auto &position, auto) {
    const Point<2> expected(before[id][0] * (1. + time_step * a),
                            before[id][1] * (1. + time_step * b));
    largest = std::max(largest, position.distance(expected));
  });
  std::cout << "largest error of the positions  " << largest << std::endl;
  EXPECT_LT(largest, 1e-15);
}



TYPED_TEST(AxisymmetricKinematics, RatesAreThoseNextToTheAxisToo)
{
  for (const double distance : {1e-3, 1e-6, 1e-9, 1e-12})
    {
      this->move_to_axis(distance);
      this->fixture.change_particles([](auto, auto &, auto state) {
        std::copy_n(stress_before.data(),
                    4,
                    state.begin() + StageLayout::stress);
        state[StageLayout::density] = 1500.;
      });
      this->set_velocity_and_move();
      this->expect_exact_rates(distance);
    }
}
