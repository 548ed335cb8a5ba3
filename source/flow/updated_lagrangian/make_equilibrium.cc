#include <sandglass/choices/choose_kinematics.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/flow/updated_lagrangian/make_material_equilibrium.h>

namespace Sandglass
{
  template <int dim>
  std::unique_ptr<Equilibrium<dim>>
  make_equilibrium(const ElementGrid<dim>   &grid,
                   const Formulation         formulation,
                   const MaterialParameters &material,
                   const Tensor<1, dim>     &gravity)
  {
    std::unique_ptr<Equilibrium<dim>> equilibrium;
    choose_kinematics<dim>(formulation, [&](const auto kinematics) {
      equilibrium =
        make_material_equilibrium<typename decltype(kinematics)::Type>(grid,
                                                                       material,
                                                                       gravity);
    });
    return equilibrium;
  }



#define INSTANTIATE(dim)                                            \
  template std::unique_ptr<Equilibrium<dim>> make_equilibrium<dim>( \
    const ElementGrid<dim> &,                                       \
    const Formulation,                                              \
    const MaterialParameters &,                                     \
    const Tensor<1, dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
