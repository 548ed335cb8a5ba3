#ifndef sandglass_material_proportional_hypoplasticity_h
#define sandglass_material_proportional_hypoplasticity_h

#include <sandglass/material/hypoplastic.h>

namespace Sandglass
{
  /// What hypoplastic laws share that have four constants, C_1 to C_4, and a
  /// rate of stress in proportion to stress. The void ratio is carried along
  /// without effect.
  template <typename Law>
  class ProportionalHypoplasticity : public Hypoplastic<Law>
  {
  public:
    explicit ProportionalHypoplasticity(const MaterialConstants &constants)
      : Hypoplastic<Law>(constants)
      , C_1(law_constant<Law>(constants, "C_1"))
      , C_2(law_constant<Law>(constants, "C_2"))
      , C_3(law_constant<Law>(constants, "C_3"))
      , C_4(law_constant<Law>(constants, "C_4"))
    {}

    /// The loosest skeleton that pressure can hold together has about 1.2 times
    /// the void ratio of loosely filled material (Herle and Gudehus 1999).
    double
    loosest_density_share() const
    {
      return (1. + this->initial_void_ratio) /
             (1. + 1.2 * this->initial_void_ratio);
    }

  protected:
    const double C_1, C_2, C_3, C_4;
  };
} // namespace Sandglass

#endif
