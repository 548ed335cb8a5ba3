#include <deal.II/base/mpi.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "solid_fixture.h"

using namespace Sandglass;

namespace
{
  using Layout = SolidFixture::Layout;

  class SolidRanks : public testing::TestWithParam<CellType>
  {
  protected:
    /// A heap that falls apart in a corner of two walls and the floor.
    static Mesh<3>
    heap()
    {
      Box box;
      box.cell_type = GetParam();
      box.upper     = Point<3>(0.6, 0.6, 0.6);
      box.n         = {{6, 6, 6}};
      box.is_filled = [](const Point<3> &p) {
        return p[0] < 0.3 && p[1] < 0.5 && p[2] < 0.4;
      };
      return box.mesh();
    }

    /// Position and stress of all particles on all ranks.
    static std::map<types::particle_index, std::array<double, 9>>
    particles_of(const SolidFixture &fixture, const MPI_Comm communicator)
    {
      std::map<types::particle_index, std::array<double, 9>> own, all;
      fixture.for_each_particle([&](auto id, const auto &position, auto state) {
        for (unsigned int d = 0; d < 3; ++d)
          own[id][d] = position[d];
        std::copy_n(state.begin() + Layout::stress, 6, own[id].begin() + 3);
      });
      for (const auto &of_rank : Utilities::MPI::all_gather(communicator, own))
        all.insert(of_rank.begin(), of_rank.end());
      return all;
    }
  };
} // namespace

INSTANTIATE_TEST_SUITE_P(CellTypes,
                         SolidRanks,
                         testing::Values(CellType::hexahedron,
                                         CellType::tetrahedron));

TEST_P(SolidRanks, TogetherFindWhatOneFindsAlone)
{
  SolidFixture together, alone;
  together.start(heap());
  alone.start(heap(), MPI_COMM_SELF);
  for (unsigned int n = 0; n < 150; ++n)
    {
      together.stage->step();
      alone.stage->step();
    }
  const auto expected = particles_of(alone, MPI_COMM_SELF);
  const auto found    = particles_of(together, MPI_COMM_WORLD);
  EXPECT_EQ(found.size(), expected.size());
  double scale = 0.;
  for (const auto &[id, numbers] : expected)
    for (unsigned int c = 3; c < 9; ++c)
      scale = std::max(scale, std::abs(numbers[c]));
  for (const auto &[id, numbers] : expected)
    for (unsigned int c = 0; c < 9; ++c)
      EXPECT_NEAR(found.at(id)[c], numbers[c], 1e-9 * (c < 3 ? 1. : scale));
}

TEST_P(SolidRanks, GoOnFromACheckpointBitByBit)
{
  SolidFixture whole, second;
  whole.start(heap());
  second.start(heap());
  for (unsigned int n = 0; n < 60; ++n)
    whole.stage->step();
  std::ostringstream out;
  {
    boost::archive::binary_oarchive archive(out);
    whole.stage->save(archive);
  }
  const std::string text = Utilities::MPI::broadcast(MPI_COMM_WORLD, out.str());
  std::istringstream              in(text);
  boost::archive::binary_iarchive archive(in);
  second.stage->load(archive);
  for (unsigned int n = 0; n < 60; ++n)
    {
      whole.stage->step();
      second.stage->step();
    }
  const auto expected = particles_of(whole, MPI_COMM_WORLD);
  const auto found    = particles_of(second, MPI_COMM_WORLD);
  EXPECT_TRUE(found == expected);
}
