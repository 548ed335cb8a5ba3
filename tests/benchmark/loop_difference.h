#ifndef sandglass_tests_benchmark_loop_difference_h
#define sandglass_tests_benchmark_loop_difference_h

#include <algorithm>
#include <cmath>

#include "flowing_silo.h"
#include "plain_loop.h"

/// Kinetic energy of all particles, in J.
inline double
kinetic_energy(const dealii::Particles::ParticleHandler<2> &particles)
{
  double energy = 0.;
  for (const auto &particle : particles)
    {
      const double *state    = particle.get_properties().data();
      const double *velocity = state + StageLayout::velocity;
      energy += 0.5 * state[StageLayout::mass] *
                (velocity[0] * velocity[0] + velocity[1] * velocity[1]);
    }
  return energy;
}

/// Largest difference between the two loops' nodal sums over the largest value
/// of its kind, or between their energies.
template <typename Setting>
double
loop_difference(const FlowingSilo<Setting> &silo, PlainLoop<Setting> &plain)
{
  using NodalSum = Sandglass::NodalSum<2>;

  plain.sum_at_nodes();
  const double energy = kinetic_energy(silo.stage->particles().handler());
  double       result = std::abs(kinetic_energy(plain.handler) / energy - 1.);
  for (const auto &[first, n] : {std::pair(NodalSum::mass, 1u),
                                 std::pair(NodalSum::momentum, 2u),
                                 std::pair(NodalSum::internal_force, 2u)})
    {
      double largest = 0., difference = 0.;
      for (unsigned int node = 0; node < silo.scene->nodes->size(); ++node)
        for (unsigned int c = first; c < first + n; ++c)
          {
            const double own   = silo.stage->nodal_fields().sums.at(node)[c];
            const double other = plain.fields.sums.at(node)[c];
            largest            = std::max(largest, std::abs(own));
            difference         = std::max(difference, std::abs(own - other));
          }
      result = std::max(result, difference / largest);
    }
  return result;
}

#endif
