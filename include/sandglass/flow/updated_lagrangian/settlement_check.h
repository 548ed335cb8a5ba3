#ifndef sandglass_flow_updated_lagrangian_settlement_check_h
#define sandglass_flow_updated_lagrangian_settlement_check_h

#include <deal.II/base/conditional_ostream.h>

#include <sandglass/flow/updated_lagrangian/static_state.h>
#include <sandglass/material/material_parameters.h>
#include <sandglass/scene/scene.h>

#include <string>

namespace Sandglass
{
  /// Settlements above this share of the material's height are doubted: the
  /// silo is no longer the one that the scene describes.
  constexpr double doubtful_settlement = 0.05;

  /// Above this share the result means nothing.
  constexpr double absurd_settlement = 0.2;

  /**
   * Warn where the material settles by more than doubtful_settlement of its
   * height. Collective; throws RunError on each rank where it is more than
   * absurd_settlement.
   */
  template <int dim>
  void
  check_settlement(const StaticState<dim>     &state,
                   const Scene<dim>           &scene,
                   const MaterialParameters   &material,
                   dealii::ConditionalOStream &log);

  /**
   * What to say where no state at rest is found: that the material is too soft
   * for its weight, or nothing if it is not. Without walls a column settles by
   * the share rho g H / (2 M) of its height H, where M is the modulus of
   * uniaxial strain.
   */
  template <int dim>
  std::string
  doubt_stiffness(const Scene<dim> &scene, const MaterialParameters &material);
} // namespace Sandglass

#endif
