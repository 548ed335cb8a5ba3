#include <deal.II/base/numbers.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/walls/boundary_role.h>
#include <sandglass/walls/wall_parameters.h>

#include <cmath>
#include <string>

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
               "Angle of friction between material and those walls that have "
               "none of their own below.");
    add_optional_number(*this,
                        "Floor friction angle",
                        floor_friction_angle,
                        Bounds::at_least_below(0., 90.),
                        "degrees",
                        "Angle of friction of a flat floor and of the closed "
                        "outlet in it.");
    add_optional_number(*this,
                        "Hopper friction angle",
                        hopper_friction_angle,
                        Bounds::at_least_below(0., 90.),
                        "degrees",
                        "Angle of friction of the hopper's walls.");
    add_named_numbers(
      *this,
      "Friction angles",
      friction_angles,
      NamedNumbersPattern(Bounds::at_least_below(0., 90.)),
      "degrees",
      "Angles of friction by the wall's name: wall, floor, hopper, outlet "
      "(while it is closed), or a physical group of the mesh file, which is "
      "thereby a wall; for example \"lining: 12, insert: 25\".");
    add_named_numbers(
      *this,
      "Velocities",
      velocities,
      NamedNumbersPattern(Bounds::any(), 2, 3),
      "m/s",
      "Velocities by the wall's name, as above, with which walls move in their "
      "own plane, as belts do: x and y (and z in three dimensions), for "
      "example \"floor: 0.5 0\". Walls without one are at rest, as all walls "
      "are for the static stage. A closed outlet moves as the floor does.");
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
    add_number(*this,
               "Box depth",
               box_depth,
               Bounds::at_least(0.),
               "m",
               "Distance between the front and the back of a box that a plane "
               "silo is the middle of. Their friction, 2 mu p over this depth, "
               "slows the flow down; the state at rest does without. 0: none.");
    add_optional_number(*this,
                        "Box friction angle",
                        box_friction_angle,
                        Bounds::at_least_below(0., 90.),
                        "degrees",
                        "Angle of friction of the box's front and back; empty: "
                        "as Friction angle.");
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
  WallParameters::friction_angle_of(const std::string &wall) const
  {
    const auto own = friction_angles.find(wall);
    if (own != friction_angles.end())
      return own->second[0];
    if (wall == name_of(BoundaryRole::outlet))
      return friction_angle_of(std::string(name_of(BoundaryRole::floor)));
    if (wall == name_of(BoundaryRole::floor))
      return floor_friction_angle.value_or(friction_angle);
    if (wall == name_of(BoundaryRole::hopper))
      return hopper_friction_angle.value_or(friction_angle);
    return friction_angle;
  }



  double
  WallParameters::box_friction_coefficient() const
  {
    return std::tan(box_friction_angle.value_or(friction_angle) *
                    dealii::numbers::PI / 180.);
  }



  void
  WallParameters::check() const
  {
    const auto refuse_both = [this](const std::optional<double> &angle,
                                    const std::string           &part,
                                    const std::string           &other_name) {
      if (angle && friction_angles.count(part) > 0)
        throw InputError("Walls",
                         "Friction angles",
                         to_text(*friction_angles.find(part)),
                         "allowed is one friction angle for each wall, but '" +
                           other_name + "' is set as well");
    };
    refuse_both(floor_friction_angle, "floor", "Floor friction angle");
    refuse_both(hopper_friction_angle, "hopper", "Hopper friction angle");
  }
} // namespace Sandglass
