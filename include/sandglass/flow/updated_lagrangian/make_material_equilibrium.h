#ifndef sandglass_flow_updated_lagrangian_make_material_equilibrium_h
#define sandglass_flow_updated_lagrangian_make_material_equilibrium_h

#include <sandglass/flow/updated_lagrangian/equilibrium.h>
#include <sandglass/material/material_parameters.h>

namespace Sandglass
{
  /// The equilibrium of one kinematics, with the law that the parameters name.
  /// Defined and instantiated by cmake/choices.cmake.
  template <typename Kinematics>
  std::unique_ptr<Equilibrium<Kinematics::dim>>
  make_material_equilibrium(const ElementGrid<Kinematics::dim> &grid,
                            const MaterialParameters           &material,
                            const Tensor<1, Kinematics::dim>   &gravity);
} // namespace Sandglass

#endif
