#include <sandglass/flow/particle_in_cell/particle_splitting.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "all_settings.h"
#include "random_engine.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// What has to stay, each over its size at the start: mass, mass times
  /// position, momentum, angular momentum, and stress times volume.
  using Totals = std::array<double, 10>;

  /// A square of 4 x 4 squares, 1 m from the axis; random states.
  template <typename TypeParam>
  class ParticleSplittingTest : public testing::Test
  {
  protected:
    using Splitting  = ParticleSplitting<TypeParam>;
    using Kinematics = typename TypeParam::Kinematics;
    using Configuration =
      InitialConfiguration<Kinematics, TypeParam::cell_type>;

    ParticleSplittingTest()
    {
      fixture.formulation = Kinematics::formulation;
      Rectangle rectangle;
      rectangle.cell_type = TypeParam::cell_type;
      rectangle.lower     = Point<2>(1., 0.);
      rectangle.upper     = Point<2>(2., 1.);
      fixture.start(rectangle.mesh());
      geometry =
        std::make_unique<CellGeometry<TypeParam::cell_type>>(*fixture.scene);
      initial_configuration =
        std::make_unique<Configuration>(*fixture.scene, *geometry);
      sums = std::make_unique<NodalSums<TypeParam>>(*geometry,
                                                    0.,
                                                    std::vector<Point<2>>());
      set_states();
    }

    void
    set_states()
    {
      auto         random = random_engine();
      const double range  = random.max();
      fixture.change_particles([&](auto, const auto &, auto state) {
        for (unsigned int p = 0; p < StageLayout::n_properties; ++p)
          if (p != StageLayout::mass && p != StageLayout::density)
            state[p] = random() / range - 0.5;
        state[StageLayout::density] *= 1. + 0.1 * random() / range;
      });
      stretch(Tensor<1, 2>({1., 0.}));
    }

    /// v^L grows along a direction.
    void
    stretch(const Tensor<1, 2> &direction)
    {
      velocity = std::make_unique<NodalField<2>>(
        fixture.at_nodes([&](const Point<2> &position) {
          return (position * direction) * direction;
        }));
    }

    /// Multiply the masses of particles with an even id.
    void
    enlarge(const double factor)
    {
      fixture.change_particles([&](auto id, const auto &, auto state) {
        if (id % 2 == 0)
          state[StageLayout::mass] *= factor;
      });
    }

    Splitting
    make_splitting(const bool is_on) const
    {
      return {*geometry,
              *initial_configuration,
              fixture.material.density,
              fixture.material.density,
              is_on};
    }

    /// @return how many particles there are more.
    unsigned int
    split()
    {
      unsigned int n_more = 0;
      fixture.stage->edit_blocks([&](auto &blocks) {
        const unsigned int before = blocks.n_particles();
        sums->cells.compute(blocks);
        make_splitting(true).split(blocks,
                                   *velocity,
                                   [&](const unsigned int cell) {
                                     sums->cells.compute(blocks, cell);
                                   });
        n_more = blocks.n_particles() - before;
      });
      return n_more;
    }

    Totals
    totals() const
    {
      Totals result{};
      fixture.for_each_particle([&](auto, const auto &x, auto state) {
        const double  m      = state[StageLayout::mass];
        const double *v      = &state[StageLayout::velocity];
        const double  volume = m / state[StageLayout::density];
        const Totals  own    = {{m,
                                 m * x[0],
                                 m * x[1],
                                 m * v[0],
                                 m * v[1],
                                 m * (x[0] * v[1] - x[1] * v[0]),
                                 volume * state[StageLayout::stress],
                                 volume * state[StageLayout::stress + 1],
                                 volume * state[StageLayout::stress + 2],
                                 volume * state[StageLayout::stress + 3]}};
        for (unsigned int i = 0; i < own.size(); ++i)
          result[i] += own[i];
      });
      return result;
    }

    StageFixture                                        fixture;
    std::unique_ptr<CellGeometry<TypeParam::cell_type>> geometry;
    std::unique_ptr<Configuration>                      initial_configuration;
    /// v^L
    std::unique_ptr<NodalField<2>>        velocity;
    std::unique_ptr<NodalSums<TypeParam>> sums;
  };

  TYPED_TEST_SUITE(ParticleSplittingTest, AllSettings);
} // namespace



TYPED_TEST(ParticleSplittingTest, KeepsWhatParticlesCarry)
{
  this->enlarge(2.5);
  const Totals before = this->totals();
  EXPECT_GT(this->split(), 20u);
  const Totals after = this->totals();
  for (unsigned int i = 0; i < before.size(); ++i)
    EXPECT_NEAR(after[i] / before[i], 1., 1e-12) << "total " << i;
  EXPECT_EQ(this->split(), 0u) << "halves are not too large";
}



TYPED_TEST(ParticleSplittingTest, HalvesLieInTheCellAlongTheExtension)
{
  this->stretch(Tensor<1, 2>({0.6, 0.8}));
  this->enlarge(2.5);
  this->split();
  const auto &blocks = this->fixture.stage->particles().blocks();
  std::set<types::particle_index> ids;
  unsigned int                    n_pairs = 0;
  blocks.for_each([&](const ParticleSlot &slot) {
    const auto  particle = blocks.parcel(slot);
    const auto &shape    = this->geometry->shape(slot.cell);
    EXPECT_TRUE(ids.insert(particle.id).second);
    EXPECT_TRUE(
      CellGeometry<TypeParam::cell_type>::is_inside(particle.reference_point,
                                                    0.));
    EXPECT_LT(
      shape.to_real(particle.reference_point).distance(particle.location),
      1e-12);
    // Nothing has moved yet, so the initial position is in the same cell.
    const Point<2> start = this->initial_configuration->position(particle.id);
    EXPECT_TRUE(
      CellGeometry<TypeParam::cell_type>::is_inside(shape.to_reference(start),
                                                    0.));
    const Tensor<1, 2> way = particle.location - start;
    if (way.norm() > 1e-12)
      {
        ++n_pairs;
        EXPECT_NEAR(std::abs(way * Tensor<1, 2>({0.6, 0.8})) / way.norm(),
                    1.,
                    1e-12);
      }
  });
  EXPECT_GT(n_pairs, 20u);
}



TYPED_TEST(ParticleSplittingTest, SumsStayThoseOfTheParticles)
{
  this->enlarge(2.5);
  this->split();
  const auto          &blocks = this->fixture.stage->particles().blocks();
  NodalSums<TypeParam> anew(*this->geometry, 0., {});
  anew.cells.compute(blocks);
  for_each_filled_cell(blocks, [&](const unsigned int cell) {
    for (unsigned int i = 0; i < anew[cell].values.size(); ++i)
      EXPECT_DOUBLE_EQ((*this->sums)[cell].values[i], anew[cell].values[i]);
  });
}



// Particles far too large, as behind a sudden step of the mesh: their halves
// find room all the same and are halved in their turn, except for some at the
// edges, which wait.
TYPED_TEST(ParticleSplittingTest, MuchTooLargeParticlesEndNearTheirShare)
{
  this->enlarge(64.);
  for (unsigned int look = 0; look < 20; ++look)
    this->split();
  unsigned int n = 0, n_large = 0;
  this->fixture.for_each_particle([&](auto id, const auto &, auto state) {
    const double share =
      state[StageLayout::mass] / (this->fixture.material.density *
                                  this->initial_configuration->volume(id));
    ++n;
    n_large += share > 4.;
  });
  EXPECT_GT(n, 500u);
  EXPECT_LT(n_large, 0.3 * n);
}



TYPED_TEST(ParticleSplittingTest, LeavesOthersAlone)
{
  EXPECT_EQ(this->split(), 0u) << "particles as at the start";

  this->enlarge(2.5);
  EXPECT_FALSE(this->make_splitting(false).is_on());

  this->fixture.change_particles([&](auto, const auto &, auto state) {
    state[StageLayout::density] = 0.99 * this->fixture.material.density;
    for (unsigned int c = 0; c < StageLayout::n_components; ++c)
      state[StageLayout::stress + c] = 0.;
  });
  EXPECT_EQ(this->split(), 0u) << "separated particles";
}



// On a mesh of one size not; where a row of cells is a hundredth as high, so
// that it holds particles a hundredth as large, it is.
TYPED_TEST(ParticleSplittingTest, IsNeededWhereCellsDifferInVolume)
{
  EXPECT_FALSE(
    cells_differ_much(this->fixture.scene->mesh, *this->initial_configuration));

  Mesh<2> mesh = this->fixture.scene->mesh;
  for (auto &vertex : mesh.vertices)
    if (vertex[1] == 0.25)
      vertex[1] = 0.0025;
  const auto needs_it = [&]() {
    this->fixture.start(mesh);
    const CellGeometry<TypeParam::cell_type> geometry(*this->fixture.scene);
    const InitialConfiguration<typename TypeParam::Kinematics,
                               TypeParam::cell_type>
      configuration(*this->fixture.scene, geometry);
    return cells_differ_much(mesh, configuration);
  };
  EXPECT_TRUE(needs_it());

  // Empty cells don't count.
  for (auto &cell : mesh.cells)
    for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
      if (mesh.vertices[cell.vertices[v]][1] == 0.)
        cell.is_filled = false;
  EXPECT_FALSE(needs_it());
}



// Particles of large cells are put into small ones below them.
TYPED_TEST(ParticleSplittingTest, TheStageSplitsWhereItIsNeededAndAllowed)
{
  auto      &fixture       = this->fixture;
  const auto n_more_halves = [&](const double         height_of_lowest_row,
                                 const SplitParticles when) {
    Mesh<2> mesh = fixture.scene->mesh;
    for (auto &vertex : mesh.vertices)
      if (vertex[1] > 0. && vertex[1] < 0.3)
        vertex[1] = height_of_lowest_row;
    fixture.parameters.split_particles = when;
    auto              &stage           = fixture.start(mesh);
    const unsigned int before          = stage.view().n_particles();
    stage.start_from(
      [&](const unsigned int cell, const Point<2> &reference) {
        const CellGeometry<TypeParam::cell_type> geometry(*fixture.scene);
        InitialState<2> state{{}, SymmetricComponents<4>::Zero(), 0.99};
        const double    y = geometry.shape(cell).to_real(reference)[1];
        if (y > height_of_lowest_row && y < 0.5)
          state.displacement[1] = 0.6 * height_of_lowest_row - y;
        return state;
      },
      {});
    for (unsigned int step = 0; step < 40; ++step)
      stage.step();
    return stage.view().n_particles() - before;
  };
  EXPECT_GT(n_more_halves(0.05, SplitParticles::where_needed), 20u);
  EXPECT_EQ(n_more_halves(0.05, SplitParticles::never), 0u);
  EXPECT_EQ(n_more_halves(0.25, SplitParticles::where_needed), 0u);
}



TYPED_TEST(ParticleSplittingTest, HalvesHaveIdsOfTheirOwn)
{
  const auto n = this->fixture.stage->particles().blocks().n_particles();
  std::vector<types::particle_index> last = {5};
  std::set<types::particle_index>    all  = {5};
  for (unsigned int generation = 0; generation < 10; ++generation)
    {
      std::vector<types::particle_index> next;
      for (const auto id : last)
        for (const auto half : this->initial_configuration->halves(id))
          {
            EXPECT_EQ(half % n, 5u);
            EXPECT_TRUE(all.insert(half).second);
            next.push_back(half);
          }
      last = next;
    }

  // Take halves until no ids are left, without an overflow.
  types::particle_index id = 5;
  while (this->initial_configuration->has_halves(id))
    {
      const auto halves = this->initial_configuration->halves(id);
      ASSERT_GT(halves[0], id);
      ASSERT_GT(halves[1], halves[0]);
      id = halves[1];
    }
  EXPECT_GT(id, std::numeric_limits<types::particle_index>::max() / 5);
}
