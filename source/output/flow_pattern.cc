#include <deal.II/base/mpi.h>

#include <sandglass/output/flow_pattern.h>

#include <array>

namespace Sandglass
{
  namespace
  {
    /// Stagnant mass of this rank's particles above the outlet level, in kg.
    double
    stagnant_mass_of_rank(
      const FlowView                                    &view,
      const double                                       displacement,
      const std::function<void(const ParticleRecord &)> &also)
    {
      double mass = 0.;
      if (displacement > 0. || also)
        view.for_each_particle([&](const ParticleRecord &particle) {
          if (particle.location[1] >= 0. &&
              particle.location.distance_square(particle.initial_location) <=
                displacement * displacement)
            mass += particle.mass;
          if (also)
            also(particle);
        });
      return mass;
    }
  } // namespace



  FlowPattern::FlowPattern(
    const FlowView                                    &view,
    const double                                       stagnant_displacement,
    const double                                       symmetry_factor,
    const MPI_Comm                                     communicator,
    const std::function<void(const ParticleRecord &)> &also)
  {
    const bool                  counts_mass = stagnant_displacement > 0.;
    const WallArea              area        = view.wall_area();
    const std::array<double, 3> of_rank     = {
          {area.touching,
           area.sliding,
           stagnant_mass_of_rank(view, stagnant_displacement, also)}};

    std::array<double, 3> sums;
    Utilities::MPI::sum(ArrayView<const double>(of_rank.data(), 3),
                        communicator,
                        ArrayView<double>(sums.data(), 3));
    if (sums[0] > 0.)
      slipping_wall_share = sums[1] / sums[0];
    if (counts_mass)
      stagnant_mass = symmetry_factor * sums[2];
  }
} // namespace Sandglass
