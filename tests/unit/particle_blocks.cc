#include <sandglass/particles/particle_blocks.h>
#include <sandglass/particles/particle_layout.h>

#include <gtest/gtest.h>

#include <numeric>

#include "random_engine.h"

using namespace Sandglass;

namespace
{
  using Layout = ParticleLayout<2, 4, 0>;
  using Blocks = ParticleBlocks<Layout>;

  /// Cell, id and mass of all particles, in the order of the blocks.
  std::vector<std::array<double, 3>>
  contents(const Blocks &blocks)
  {
    std::vector<std::array<double, 3>> result;
    blocks.for_each([&](const ParticleSlot &slot) {
      const auto parcel = blocks.parcel(slot);
      result.push_back({{double(parcel.cell),
                         double(parcel.id),
                         parcel.properties[Layout::mass]}});
    });
    return result;
  }

  /// Particles that have come and gone, so that the blocks of a cell lie
  /// anywhere and some are unused.
  Blocks
  mixed_blocks(const unsigned int n_cells)
  {
    std::vector<unsigned int> cells(n_cells);
    std::iota(cells.begin(), cells.end(), 0u);
    Blocks       blocks(n_cells, cells);
    std::mt19937 engine = random_engine();
    const auto   any_of = [&](const unsigned int n) {
      return std::uniform_int_distribution<unsigned int>(0, n - 1)(engine);
    };
    for (unsigned int k = 0; k < 2000; ++k)
      {
        Blocks::Parcel parcel{};
        parcel.cell                     = any_of(n_cells);
        parcel.id                       = k;
        parcel.properties[Layout::mass] = 1. + k;
        blocks.insert(parcel);
        const unsigned int cell  = any_of(n_cells);
        const unsigned int block = blocks.first_block(cell);
        if (k % 3 != 0 && block != Blocks::none)
          blocks.remove({cell, block, any_of(blocks.n_lanes(block))});
      }
    return blocks;
  }
} // namespace

TEST(ParticleBlocks, SortingKeepsParticlesAndTheirOrder)
{
  Blocks     blocks = mixed_blocks(20);
  const auto before = contents(blocks);
  ASSERT_FALSE(before.empty());
  blocks.sort();
  EXPECT_EQ(contents(blocks), before);
}

TEST(ParticleBlocks, SortingLeavesBlocksInOrder)
{
  Blocks blocks = mixed_blocks(20);
  blocks.sort();
  unsigned int next = 0;
  for (const unsigned int cell : blocks.cells())
    blocks.for_each_block_in_cell(cell, [&](const unsigned int block) {
      EXPECT_EQ(block, next++);
    });
}

TEST(ParticleBlocks, ParticlesComeAndGoAfterSorting)
{
  Blocks             blocks = mixed_blocks(20);
  const unsigned int n      = blocks.n_particles();
  blocks.sort();
  Blocks::Parcel parcel{};
  parcel.cell                     = 3;
  parcel.id                       = 12345;
  parcel.properties[Layout::mass] = 7.;
  const ParticleSlot slot         = blocks.insert(parcel);
  EXPECT_EQ(blocks.n_particles(), n + 1);
  EXPECT_EQ(blocks.id(slot), 12345u);
  blocks.remove(slot);
  EXPECT_EQ(blocks.n_particles(), n);
  EXPECT_EQ(contents(blocks).size(), n);
}
