#ifndef sandglass_particles_particle_layout_h
#define sandglass_particles_particle_layout_h

namespace Sandglass
{
  /**
   * Places of a particle's state among the numbers that it carries: the only
   * list of them. In the plane eight numbers without a law's own fill one cache
   * line; what never changes (initial position, layer) follows from the
   * particle's id instead, see InitialConfiguration.
   *
   * @tparam n_components_  of stress.
   * @tparam n_law_numbers_ of the law's state variables.
   */
  template <int dim_, int n_components_, unsigned int n_law_numbers_>
  struct ParticleLayout
  {
    static constexpr int          dim           = dim_;
    static constexpr int          n_components  = n_components_;
    static constexpr unsigned int n_law_numbers = n_law_numbers_;

    enum Property : unsigned int
    {
      mass         = 0, ///< in kg (plane strain: per metre of depth)
      velocity     = 1, ///< in m/s
      stress       = velocity + dim,        ///< see SymmetricComponents, in Pa
      density      = stress + n_components, ///< in kg/m^3
      law_state    = density + 1,           ///< see StateVariable
      n_properties = law_state + n_law_numbers
    };
  };
} // namespace Sandglass

#endif
