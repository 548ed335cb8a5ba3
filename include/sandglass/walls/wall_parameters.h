#ifndef sandglass_walls_wall_parameters_h
#define sandglass_walls_wall_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <sandglass/base/parameter_entries.h>
#include <sandglass/walls/friction.h>

#include <optional>

namespace Sandglass
{
  /// Section `Walls`: friction between the material and the silo, and the
  /// walls' motion.
  class WallParameters : public dealii::ParameterAcceptor
  {
  public:
    WallParameters();

    /// What contact makes zero in the direction of a wall's normal.
    enum class NormalCondition
    {
      velocity,    ///< at the end of the step: what hits a wall stops
      acceleration ///< as in the paper: contact leaves the velocity as it is
    };

    /// What the material feels at the node on the edge of the outlet.
    enum class OutletLip
    {
      floor, ///< the floor's (or hopper's) unilateral contact, as in the paper
      free   ///< no nodal contact; particles are held above the wall instead
    };

    double                friction_angle = 20.;  ///< in degrees, of other walls
    std::optional<double> floor_friction_angle;  ///< likewise
    std::optional<double> hopper_friction_angle; ///< likewise

    /// By standard part or physical group: one number, in degrees.
    NamedNumbers friction_angles;
    /// Likewise: x, y and, in three dimensions, z, in m/s.
    NamedNumbers velocities;

    double          tangential_penalty = 1e7; ///< c_T, in N/m^3
    double          penalty_limit      = 0.2; ///< of c_T A dt^2 / m; 0: none
    NormalCondition normal_condition   = NormalCondition::velocity;
    FrictionUpdate  friction_update    = FrictionUpdate::return_mapping;
    /// Of a box with a front and a back, in m; 0: none.
    double                box_depth = 0.;
    std::optional<double> box_friction_angle; ///< as friction_angle

    bool      fix_bottom_corner = true;
    OutletLip outlet_lip        = OutletLip::free;

    /// Of the wall of this name, in degrees: its own, its part's, or that of
    /// all walls.
    double
    friction_angle_of(const std::string &wall) const;

    /// Of the box's front and back.
    double
    box_friction_coefficient() const;

    /// Throws InputError where values contradict each other.
    void
    check() const;
  };
} // namespace Sandglass

#endif
