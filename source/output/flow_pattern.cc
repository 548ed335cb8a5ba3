#include <deal.II/base/mpi.h>

#include <sandglass/output/flow_pattern.h>

#include <array>

namespace Sandglass
{
  namespace
  {
    /// Of this rank's particles above the outlet level, in kg.
    double
    stagnant_mass_of_rank(ParticleStage &stage, const double displacement)
    {
      const ParticleBlocks &blocks = stage.cloud.blocks();
      double                mass   = 0.;
      blocks.for_each([&](const ParticleSlot &slot) {
        const ParticleBlock &block = blocks[slot.block];
        const Point<dim>     location =
          block.point(ParticleBlock::location, slot.lane);
        if (location[1] >= 0. &&
            location.distance_square(stage.initial_position(blocks.id(slot))) <=
              displacement * displacement)
          mass += block.values[ParticleBlock::mass][slot.lane];
      });
      return mass;
    }
  } // namespace



  FlowPattern::FlowPattern(ParticleStage &stage,
                           const double   stagnant_displacement)
  {
    const bool                  counts_mass = stagnant_displacement > 0.;
    const Contact::WallArea     area        = stage.contact.wall_area();
    const std::array<double, 3> of_rank     = {
          {area.touching,
           area.sliding,
       counts_mass ? stagnant_mass_of_rank(stage, stagnant_displacement) : 0.}};

    std::array<double, 3> sums;
    Utilities::MPI::sum(ArrayView<const double>(of_rank.data(), 3),
                        stage.scene.communicator,
                        ArrayView<double>(sums.data(), 3));
    if (sums[0] > 0.)
      slipping_wall_share = sums[1] / sums[0];
    if (counts_mass)
      stagnant_mass = stage.scene.symmetry_factor * sums[2];
  }
} // namespace Sandglass
