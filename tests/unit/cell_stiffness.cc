#include <sandglass/flow/particle_in_cell/cell_stiffness.h>
#include <sandglass/flow/particle_in_cell/law_adapter.h>
#include <sandglass/material/drucker_prager.h>

#include <gtest/gtest.h>

#include "all_settings.h"
#include "random_engine.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double density = 1500.; // kg/m^3

  /// A few distorted cells near the axis, their particles with or without
  /// stress, dense or not.
  template <typename Setting>
  struct StressedCells : StageFixture
  {
    using Geometry = CellGeometry<Setting::cell_type>;
    using Field    = NodalField<2>;

    StressedCells()
    {
      formulation            = Setting::Kinematics::formulation;
      material.density       = density;
      material.poisson_ratio = 0.3;
      Rectangle rectangle;
      rectangle.cell_type = Setting::cell_type;
      rectangle.n_x       = 3;
      rectangle.n_y       = 2;
      rectangle.displaced = [](const Point<2> &point) {
        return point + Point<2>(0.07, -0.04);
      };
      start(rectangle.mesh());
      change_particles([&](auto, const auto &, auto state) {
        const bool is_stressed = uniform(engine) < 0.5;
        for (unsigned int c = 0; c < 4; ++c)
          state[StageLayout::stress + c] =
            is_stressed ? -1e3 * (1. + uniform(engine)) : 0.;
        state[StageLayout::density] = density * (0.5 + uniform(engine));
      });
      geometry = std::make_unique<Geometry>(*scene);
    }

    Field
    random_field()
    {
      Field field(*scene->nodes);
      for (double &value : field.vector())
        value = uniform(engine) - 0.5;
      return field;
    }

    /// v^T K u, particle by particle: the work of u's elastic stress on v's
    /// strain.
    double
    work(const Field &v, const Field &u, const double smallest_density) const
    {
      const auto &blocks = stage->particles().blocks();
      double      sum    = 0.;
      blocks.for_each([&](const ParticleSlot &slot) {
        const auto state = load_state(blocks[slot.block], slot.lane);
        if (state.stress[Component::yy] != 0. ||
            state.density >= smallest_density)
          {
            const SymmetricComponents<4> strain =
              strain_of(v, slot.cell, state);
            const SymmetricComponents<4> stress =
              elasticity().stress(strain_of(u, slot.cell, state));
            sum += state.mass / state.density *
                   (strain.dot(stress) +
                    strain[Component::xy] * stress[Component::xy]);
          }
      });
      return sum;
    }

    std::unique_ptr<Geometry>              geometry;
    std::mt19937                           engine = random_engine();
    std::uniform_real_distribution<double> uniform;

  private:
    SymmetricComponents<4>
    strain_of(const Field                              &displacement,
              const unsigned int                        cell,
              const ParticleState<StageLayout, double> &state) const
    {
      const auto values = Geometry::Shape::shape_values(state.reference);
      const auto gradients =
        geometry->shape(cell).shape_gradients(state.reference);
      const auto            &nodes  = geometry->nodes(cell);
      SymmetricComponents<4> strain = SymmetricComponents<4>::Zero();
      for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          const double *u = displacement.at(nodes[i]);
          strain[Component::xx] += u[0] * gradients[i][0];
          strain[Component::yy] += u[1] * gradients[i][1];
          strain[Component::xy] +=
            0.5 * (u[0] * gradients[i][1] + u[1] * gradients[i][0]);
          if (Setting::has_hoop_strain)
            strain[Component::zz] += u[0] * values[i] / state.location[0];
        }
      return strain;
    }
  };

  template <typename Setting>
  class CellStiffnessTest : public testing::Test
  {};

  TYPED_TEST_SUITE(CellStiffnessTest, AllSettings);
} // namespace

TYPED_TEST(CellStiffnessTest, IsTheElasticWorkOfDenseParticles)
{
  StressedCells<TypeParam> cells;
  const double             smallest_density = 0.95 * density;
  const auto              &blocks           = cells.stage->particles().blocks();
  NodalSums<TypeParam>     sums(*cells.geometry, smallest_density, {});
  sums.cells.compute(blocks);
  const LawAdapter<TypeParam, DruckerPrager> law(cells.material,
                                                 cells.parameters,
                                                 *cells.geometry);
  CellStiffness<TypeParam>                   stiffness(law, *cells.geometry);
  stiffness.assemble(blocks, sums);

  auto          u = cells.random_field(), v = cells.random_field();
  NodalField<2> product(*cells.scene->nodes);
  product.start_sum();
  const double energy = stiffness.multiply(blocks, sums, u, product);

  const double expected_energy = cells.work(u, u, smallest_density);
  const double expected_work   = cells.work(v, u, smallest_density);
  EXPECT_NEAR(energy / expected_energy, 1., 1e-12);
  EXPECT_NEAR((v.vector() * product.vector()) / expected_work, 1., 1e-11);
}
