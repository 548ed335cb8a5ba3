#ifndef sandglass_particles_parcel_h
#define sandglass_particles_parcel_h

#include <deal.II/base/point.h>

#include <deal.II/particles/property_pool.h>

#include <sandglass/base/setting.h>
#include <sandglass/particles/particle_properties.h>

#include <array>

namespace Sandglass
{
  using namespace dealii;

  /// A particle on its way: all that there is of it.
  struct Parcel
  {
    unsigned int                               cell;
    types::particle_index                      id;
    Point<dim>                                 location, reference_point;
    std::array<double, Property::n_properties> properties;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &cell &id &location &reference_point &properties;
    }
  };
} // namespace Sandglass

#endif
