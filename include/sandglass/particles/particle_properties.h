#ifndef sandglass_particles_particle_properties_h
#define sandglass_particles_particle_properties_h

namespace Sandglass
{
  /**
   * Offsets of a particle's state in the property array that deal.II's
   * ParticleHandler stores: the only list of them. Eight numbers fill one cache
   * line; what never changes (initial position, layer) follows from the
   * particle's id instead, see InitialConfiguration.
   */
  namespace Property
  {
    enum Offset : unsigned int
    {
      mass     = 0, ///< in kg (plane strain: per metre of depth)
      velocity = 1, ///< two components, in m/s
      stress   = 3, ///< (xx, yy, zz, xy), in Pa
      density  = 7, ///< in kg/m^3
      n_properties
    };
  }
} // namespace Sandglass

#endif
