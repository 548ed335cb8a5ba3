#include <deal.II/base/numbers.h>

#include <sandglass/base/parameter_entries.h>
#include <sandglass/walls/wall_parameters.h>

#include <cmath>

namespace Sandglass
{
  WallParameters::WallParameters()
    : ParameterAcceptor("Walls")
  {
    using Bounds = BoundedNumber;

    add_number(*this,
               "Friction angle",
               friction_angle,
               Bounds::at_least_below(0., 90.),
               "degrees",
               "Angle of friction between material and walls.");
    add_number(*this,
               "Tangential penalty",
               tangential_penalty,
               Bounds::greater_than(0.),
               "N/m^3",
               "Stiffness c_T of sticking contact per wall area.");
    add_number(
      *this,
      "Penalty limit",
      penalty_limit,
      Bounds::at_least(0.),
      "1",
      "Largest c_T A dt^2 / m of a node with mass m and wall area A in "
      "the particle stage; where it is exceeded, the node sticks less "
      "stiffly in this step. Above one half material at rest may "
      "tremble. 0: no limit (paper).");
    add_selection<NormalCondition>(
      *this,
      "Normal condition",
      normal_condition,
      {{"velocity", NormalCondition::velocity},
       {"acceleration", NormalCondition::acceleration}},
      "What contact makes zero across a wall at its nodes: the velocity at the "
      "end of the step, or the acceleration (paper), which leaves particles "
      "near the wall the velocity with which they have come.");
    add_selection<FrictionUpdate>(
      *this,
      "Friction update",
      friction_update,
      {{"return mapping", FrictionUpdate::return_mapping},
       {"velocity sign", FrictionUpdate::velocity_sign}},
      "How friction follows a node's slip: elastically up to Coulomb's limit, "
      "or, once it slides, by the sign of its velocity (the paper's rule).");
    add_flag(*this,
             "Fix bottom corner",
             fix_bottom_corner,
             "Hold the node between the vertical wall and a flat floor.");
    add_selection<OutletLip>(
      *this,
      "Outlet lip",
      outlet_lip,
      {{"floor", OutletLip::floor}, {"free", OutletLip::free}},
      "Contact at the node on the edge of the open outlet: that of the floor "
      "or hopper beside it, or none; then particles, not the node, are held "
      "above the wall next to the outlet.");
  }



  double
  WallParameters::friction_coefficient() const
  {
    return std::tan(friction_angle * dealii::numbers::PI / 180.);
  }
} // namespace Sandglass
