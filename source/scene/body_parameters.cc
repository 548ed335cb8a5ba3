// What SceneParameters says of silos in three dimensions.

#include <sandglass/base/exceptions.h>
#include <sandglass/base/number_text.h>
#include <sandglass/base/parameter_entries.h>
#include <sandglass/scene/scene_parameters.h>

#include <cmath>

namespace Sandglass
{
  namespace
  {
    [[noreturn]] void
    refuse(const std::string &name,
           const std::string &value,
           const std::string &allowed)
    {
      throw InputError("Scene", name, value, allowed);
    }



    /// Refuse an outlet that reaches beyond the walls.
    void
    check_outlet_lies_inside(const SceneParameters &scene)
    {
      using Parameters   = SceneParameters;
      const double x     = std::abs(scene.outlet_eccentricity),
                   z     = std::abs(scene.outlet_eccentricity_along_z);
      const bool is_slot = scene.outlet_shape == Parameters::OutletShape::slot;
      const bool is_round =
        scene.outlet_shape == Parameters::OutletShape::circle;
      const double width     = scene.outlet_half_width,
                   depth     = is_round ? width :
                               is_slot  ? 0. :
                                          scene.outlet_half_depth.value_or(width);
      const double allowance = 1. + 1e-9;
      if (scene.cross_section == Parameters::CrossSection::circle)
        {
          const double farthest = is_round ? std::hypot(x, z) + width :
                                             std::hypot(x + width, z + depth);
          if (farthest > scene.half_width * allowance)
            refuse("Outlet half width",
                   number_text(width),
                   "the outlet must lie between the walls, but its farthest "
                   "point is " +
                     number_text(farthest) +
                     " m from the silo's middle; allowed is at most the Half "
                     "width of " +
                     number_text(scene.half_width) + " m");
          return;
        }
      if (x + width > scene.half_width * allowance)
        refuse("Outlet eccentricity",
               number_text(scene.outlet_eccentricity),
               "the outlet must lie between the walls: allowed is at most " +
                 number_text(scene.half_width - width) +
                 " m to either side, the Half width less the Outlet half "
                 "width");
      if (z + depth > scene.whole_half_depth() * allowance)
        refuse("Outlet eccentricity along z",
               number_text(scene.outlet_eccentricity_along_z),
               "the outlet must lie between the walls: allowed is at most " +
                 number_text(scene.whole_half_depth() - depth) +
                 " m to either side, the Half depth less the outlet's half "
                 "depth");
    }



    /// Refuse what has no meaning in two dimensions.
    void
    check_that_none_is_set(const SceneParameters &scene)
    {
      using Parameters        = SceneParameters;
      const auto refuse_unset = [](const bool         is_set,
                                   const std::string &name,
                                   const std::string &value,
                                   const std::string &allowed) {
        if (is_set)
          refuse(name,
                 value,
                 "allowed is " + allowed +
                   " unless Formulation = three dimensions");
      };
      refuse_unset(scene.cross_section != Parameters::CrossSection::rectangle,
                   "Cross section",
                   "circle",
                   "rectangle");
      refuse_unset(scene.half_depth.has_value(),
                   "Half depth",
                   number_text(scene.half_depth.value_or(0.)),
                   "auto");
      refuse_unset(scene.outlet_shape != Parameters::OutletShape::slot,
                   "Outlet shape",
                   scene.outlet_shape == Parameters::OutletShape::circle ?
                     "circle" :
                     "rectangle",
                   "slot");
      refuse_unset(scene.outlet_half_depth.has_value(),
                   "Outlet half depth",
                   number_text(scene.outlet_half_depth.value_or(0.)),
                   "auto");
      refuse_unset(scene.outlet_eccentricity_along_z != 0.,
                   "Outlet eccentricity along z",
                   number_text(scene.outlet_eccentricity_along_z),
                   "0");
      refuse_unset(scene.chosen_symmetry_planes !=
                     Parameters::SymmetryPlanes::automatic,
                   "Symmetry planes",
                   "other than auto",
                   "auto");
    }



    void
    check_symmetry_planes(const SceneParameters &scene)
    {
      const auto planes = scene.symmetry_planes();
      if (planes[0] && scene.outlet_eccentricity != 0.)
        refuse("Outlet eccentricity",
               number_text(scene.outlet_eccentricity),
               "allowed is 0 where Symmetry planes has x");
      if (planes[1] && scene.outlet_eccentricity_along_z != 0.)
        refuse("Outlet eccentricity along z",
               number_text(scene.outlet_eccentricity_along_z),
               "allowed is 0 where Symmetry planes has z");
    }
  } // namespace



  void
  SceneParameters::declare_body()
  {
    using Bounds = BoundedNumber;

    add_selection<CrossSection>(*this,
                                "Cross section",
                                cross_section,
                                {{"rectangle", CrossSection::rectangle},
                                 {"circle", CrossSection::circle}},
                                "The silo seen from above, with Formulation = "
                                "three dimensions.");
    add_automatic_number(*this,
                         "Half depth",
                         half_depth,
                         Bounds::greater_than(0.),
                         "m",
                         "Half length along z of a silo whose Cross section is "
                         "a rectangle; `auto`: the Half width, a square silo.");
    add_selection<OutletShape>(
      *this,
      "Outlet shape",
      outlet_shape,
      {{"slot", OutletShape::slot},
       {"circle", OutletShape::circle},
       {"rectangle", OutletShape::rectangle}},
      "The outlet seen from above, with Formulation = three dimensions; a slot "
      "goes from wall to wall along z (Cross section = rectangle only). With "
      "the Cross section it decides what the hopper is: a wedge (rectangle to "
      "slot), pyramid (rectangle to rectangle), cone (circle to circle), or a "
      "transition from one shape to the other.");
    add_automatic_number(*this,
                         "Outlet half depth",
                         outlet_half_depth,
                         Bounds::greater_than(0.),
                         "m",
                         "Half length along z of an outlet whose shape is a "
                         "rectangle; `auto`: the Outlet half width, a square "
                         "outlet.");
    add_number(*this,
               "Outlet eccentricity along z",
               outlet_eccentricity_along_z,
               Bounds::any(),
               "m",
               "How far from the silo's middle, along z, the middle of the "
               "outlet lies, with Formulation = three dimensions.");
    add_selection<SymmetryPlanes>(
      *this,
      "Symmetry planes",
      chosen_symmetry_planes,
      {{automatic, SymmetryPlanes::automatic},
       {"none", SymmetryPlanes::none},
       {"x", SymmetryPlanes::x},
       {"z", SymmetryPlanes::z},
       {"x and z", SymmetryPlanes::x_and_z}},
      "The planes x = 0 and z = 0 at which the mesh of a silo in three "
      "dimensions ends, so that a half (one plane) or a quarter (both) stands "
      "for the whole; `auto`: each in whose direction the outlet lies in the "
      "silo's middle and gravity has no component. For Shape = silo; results "
      "are those of the whole silo.");
  }



  std::array<bool, 2>
  SceneParameters::symmetry_planes() const
  {
    switch (chosen_symmetry_planes)
      {
        case SymmetryPlanes::none:
          return {{false, false}};
        case SymmetryPlanes::x:
          return {{true, false}};
        case SymmetryPlanes::z:
          return {{false, true}};
        case SymmetryPlanes::x_and_z:
          return {{true, true}};
        default:
          return {{outlet_eccentricity == 0. && gravity[0] == 0.,
                   outlet_eccentricity_along_z == 0. &&
                     (gravity.size() < 3 || gravity[2] == 0.)}};
      }
  }



  void
  SceneParameters::check_body() const
  {
    const bool is_body = formulation == Formulation::three_dimensions;
    const bool is_solid =
      cell_type == CellType::tetrahedron || cell_type == CellType::hexahedron;
    if (is_body != is_solid)
      refuse("Cell type",
             cell_type == CellType::triangle      ? "triangle" :
             cell_type == CellType::quadrilateral ? "quadrilateral" :
             cell_type == CellType::tetrahedron   ? "tetrahedron" :
                                                    "hexahedron",
             is_body ? "allowed is tetrahedron or hexahedron with Formulation "
                       "= three dimensions" :
                       "allowed is triangle or quadrilateral unless "
                       "Formulation = three dimensions");
    if (particles_per_cell)
      {
        const double root = is_body ? std::cbrt(*particles_per_cell) :
                                      std::sqrt(*particles_per_cell);
        if (std::abs(root - std::round(root)) > 1e-6)
          refuse("Particles per cell",
                 std::to_string(*particles_per_cell),
                 is_body ? "allowed is 1, 8, 27 or 64 in three dimensions" :
                           "allowed is 1, 4, 9, 16, 25, 36 or 64 in two "
                           "dimensions");
      }
    if (!is_body && gravity.size() != 2)
      refuse("Gravity",
             number_text(gravity[0]) + ", " + number_text(gravity[1]) + ", " +
               number_text(gravity[2]),
             "allowed are two numbers, x and y, unless Formulation = three "
             "dimensions");
    if (!is_body)
      check_that_none_is_set(*this);
    if (!is_body || shape == Shape::mesh_file)
      return;

    if (!is_symmetric)
      refuse("Symmetry",
             "false",
             "allowed is true with Formulation = three dimensions, where "
             "Symmetry planes says what part of the silo is meshed");
    const bool is_round = cross_section == CrossSection::circle;
    if (is_round && half_depth)
      refuse("Half depth",
             number_text(*half_depth),
             "allowed is auto with Cross section = circle, whose radius is the "
             "Half width");
    if (is_round && outlet_shape == OutletShape::slot)
      refuse("Outlet shape",
             "slot",
             "allowed is circle or rectangle with Cross section = circle: a "
             "slot goes from one plane wall to the other");
    if (outlet_shape != OutletShape::rectangle && outlet_half_depth)
      refuse("Outlet half depth",
             number_text(*outlet_half_depth),
             "allowed is auto unless Outlet shape = rectangle");
    if (outlet_shape == OutletShape::slot && outlet_eccentricity_along_z != 0.)
      refuse("Outlet eccentricity along z",
             number_text(outlet_eccentricity_along_z),
             "allowed is 0 with Outlet shape = slot, which goes from wall to "
             "wall along z");
    check_symmetry_planes(*this);
    check_outlet_lies_inside(*this);
  }
} // namespace Sandglass
