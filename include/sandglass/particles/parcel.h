#ifndef sandglass_particles_parcel_h
#define sandglass_particles_parcel_h

#include <deal.II/base/point.h>

#include <deal.II/particles/property_pool.h>

#include <sandglass/particles/particle_layout.h>

#include <array>

namespace Sandglass
{
  using namespace dealii;

  /// A particle on its way: all that there is of it.
  template <typename Layout>
  struct Parcel
  {
    using Point = dealii::Point<Layout::dim>;

    unsigned int                             cell;
    types::particle_index                    id;
    Point                                    location, reference_point;
    std::array<double, Layout::n_properties> properties;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &cell &id &location &reference_point &properties;
    }
  };
} // namespace Sandglass

#endif
