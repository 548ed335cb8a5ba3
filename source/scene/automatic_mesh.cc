#include <sandglass/scene/automatic_mesh.h>
#include <sandglass/scene/silo_body.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    /// Triangles across the outlet if all were as small as those at its lip:
    /// more where the outlet is round, whose rate goes with D^2.5 instead of
    /// D^1.5.
    constexpr double triangles_across_slot   = 16.;
    constexpr double triangles_across_circle = 32.;
    /// Squares across the outlet, which have one size;
    constexpr double squares_across_outlet = 12.;
    /// where a small outlet would ask for more than these in the silo, larger
    /// ones.
    constexpr double most_squares = 40000.;
    /// Squares along the half outlet and each part of the walls, at least.
    constexpr double fewest_along_line = 2.;
    /// Triangles far from the outlet, across half of the silo,
    constexpr double triangles_across_half_width = 10.;
    /// and along the shortest part of its walls.
    constexpr double triangles_along_wall = 4.;
    /// Triangles along hoppers flatter than 45 degrees, at which material flows
    /// and rests side by side (doc/results/any-silo.md),
    constexpr double triangles_along_flat_hopper = 16.;
    /// as far as it costs no more than these particle-steps up to 5 sqrt(D/g),
    /// some ten seconds of a core.
    constexpr double most_work = 2e8;
    /// Triangles of a section, times the square of their size, over its area:
    /// 2.3 if all were equilateral, and those at the lip.
    constexpr double triangles_over_squares = 2.6;
    /// Of empty cells, over the half width.
    constexpr double headroom_over_half_width = 0.2;
    /// Enough for cells that particles of other cells have come to.
    constexpr unsigned int particles_per_automatic_cell = 9;

    /// In three dimensions: cells across the outlet at its lip, of a slot and
    /// of other outlets;
    constexpr double cells_across_slot_in_space  = 12.;
    constexpr double cells_across_round_in_space = 16.;
    /// cells far from the outlet, across half of the silo,
    constexpr double cells_across_half_width_in_space = 8.;
    /// Tetrahedra are smaller by this factor: of the same size they have a
    /// third of the nodes, and let a tenth less through the outlet.
    constexpr double tetrahedra_along_cell = 1.5;
    /// In three dimensions: with eighths of hexahedra cells empty where the
    /// flow converges, which shakes the material and lets a tenth more through.
    constexpr unsigned int particles_per_automatic_tetrahedron = 8;
    constexpr unsigned int particles_per_automatic_hexahedron  = 27;



    /// To three digits.
    double
    rounded(const double size)
    {
      // The number of decimals as an integer power, and a quotient of two exact
      // numbers: the double next to the decimal number, as a file's reader has
      // it.
      const int    digits = 2 - static_cast<int>(std::floor(std::log10(size)));
      const double factor = std::pow(10., std::abs(digits));
      return digits >= 0 ? std::round(size * factor) / factor :
                           std::round(size / factor) * factor;
    }



    /// Horizontal length of the hopper, in m; of the shorter one where there
    /// are two.
    double
    hopper_run(const SceneParameters &silo)
    {
      return silo.half_width - std::abs(silo.outlet_eccentricity) -
             silo.outlet_half_width;
    }



    /// Length of the hopper's wall, in m.
    double
    hopper_length(const SceneParameters &silo)
    {
      return std::hypot(silo.hopper_height, hopper_run(silo));
    }



    /// Length of the shortest part of the silo's walls that the mesh has to
    /// follow, in m.
    double
    shortest_wall(const SceneParameters &silo)
    {
      double shortest = silo.half_width;
      if (silo.wall_height > 0.)
        shortest = std::min(shortest, silo.wall_height);
      if (silo.hopper_height > 0.)
        shortest = std::min(shortest, hopper_length(silo));
      return shortest;
    }



    /// Area of the section that material fills, in m^2.
    double
    filled_area(const SceneParameters &silo)
    {
      const double level = silo.fill_height.value_or(silo.silo_height());
      if (level < silo.hopper_height)
        {
          const double width_there =
            silo.outlet_half_width +
            (silo.half_width - silo.outlet_half_width) * level /
              silo.hopper_height;
          return (silo.is_symmetric ? 1. : 2.) * level *
                 (silo.outlet_half_width + width_there) / 2.;
        }
      const double wall_height =
        silo.fill_height ? level - silo.hopper_height : silo.wall_height;
      return (silo.is_symmetric ? 1. : 2.) *
             (silo.half_width * wall_height +
              (silo.half_width + silo.outlet_half_width) / 2. *
                silo.hopper_height);
    }



    /// The size of squares, in m.
    double
    size_of_squares(const SceneParameters &silo)
    {
      const double size =
        std::max(2. * silo.outlet_half_width / squares_across_outlet,
                 std::sqrt(filled_area(silo) / most_squares));
      // However many it takes, outlet and walls hold some.
      return std::min({size,
                       silo.outlet_half_width / fewest_along_line,
                       shortest_wall(silo) / fewest_along_line});
    }



    /// What triangles of these sizes cost up to 5 sqrt(D/g), over most_work.
    double
    relative_work(const SceneParameters &silo,
                  const double           elsewhere,
                  const double           at_lip,
                  const double           wave_speed)
    {
      const double gravity = std::hypot(silo.gravity[0], silo.gravity[1]);
      if (!silo.outlet_is_open || !(gravity > 0.))
        return 0.;
      const double particles = particles_per_automatic_cell *
                               triangles_over_squares * filled_area(silo) /
                               (elsewhere * elsewhere);
      const double time = 5. * std::sqrt(2. * silo.outlet_half_width / gravity);
      const double steps = time * wave_speed / at_lip;
      return particles * steps / most_work;
    }



    /// The size of triangles elsewhere that a flat hopper asks for, as far as
    /// the work allows: it goes with their number.
    double
    size_along_hopper(const SceneParameters &silo,
                      const double           elsewhere,
                      const double           work)
    {
      const bool is_flat = silo.hopper_height < hopper_run(silo);
      if (!(silo.hopper_height > 0.) || !is_flat)
        return elsewhere;
      return std::clamp(hopper_length(silo) / triangles_along_flat_hopper,
                        elsewhere * std::sqrt(std::min(1., work)),
                        elsewhere);
    }



    Resolution
    resolution_of_triangles(const SceneParameters &silo,
                            const double           wave_speed)
    {
      Resolution resolution;
      double elsewhere = std::min(silo.half_width / triangles_across_half_width,
                                  shortest_wall(silo) / triangles_along_wall);
      // A low layer is no reason for a mesh that is ever so fine.
      if (silo.fill_height)
        elsewhere =
          std::max(elsewhere / 2.,
                   std::min(elsewhere,
                            *silo.fill_height / triangles_along_wall));
      const double suits_outlet =
        std::min(elsewhere,
                 2. * silo.outlet_half_width /
                   (silo.formulation == Formulation::axisymmetric ?
                      triangles_across_circle :
                      triangles_across_slot));
      const double work =
        relative_work(silo, elsewhere, suits_outlet, wave_speed);
      elsewhere           = size_along_hopper(silo, elsewhere, work);
      const double at_lip = std::min(suits_outlet, elsewhere);
      const double given_at_lip =
        silo.outlet_element_size.value_or(rounded(at_lip));
      resolution.outlet_element_size = given_at_lip;
      resolution.element_size        = given_at_lip > 0. ?
                                         std::max(rounded(elsewhere), given_at_lip) :
                                         rounded(at_lip);
      return resolution;
    }



    /// Of tetrahedra and hexahedra, which both can be smaller at the lip.
    Resolution
    resolution_in_space(const SceneParameters &silo)
    {
      const SiloBody body(silo);
      const double   half_width =
        std::min(body.wall.half_width, body.wall.half_depth);
      const double outlet_width =
        2. * (body.outlet_is_slot ?
                body.outlet.half_width :
                std::min(body.outlet.half_width, body.outlet.half_depth));
      const double factor =
        silo.cell_type == CellType::tetrahedron ? tetrahedra_along_cell : 1.;
      const double elsewhere =
        std::min(half_width / (factor * cells_across_half_width_in_space),
                 shortest_wall(silo) / triangles_along_wall);
      const double at_lip =
        std::min(elsewhere,
                 outlet_width / (factor * (body.outlet_is_slot ?
                                             cells_across_slot_in_space :
                                             cells_across_round_in_space)));
      Resolution   resolution;
      const double given_at_lip =
        silo.outlet_element_size.value_or(rounded(at_lip));
      resolution.outlet_element_size = given_at_lip;
      resolution.element_size        = given_at_lip > 0. ?
                                         std::max(rounded(elsewhere), given_at_lip) :
                                         rounded(at_lip);
      return resolution;
    }
  } // namespace



  double
  automatic_headroom(const SceneParameters &silo)
  {
    return rounded(headroom_over_half_width * silo.half_width);
  }



  Resolution
  automatic_resolution(const SceneParameters &silo, const double wave_speed)
  {
    Resolution resolution;
    if (silo.formulation == Formulation::three_dimensions)
      {
        if (silo.shape == SceneParameters::Shape::silo)
          resolution = resolution_in_space(silo);
        resolution.particles_per_cell =
          silo.cell_type == CellType::tetrahedron ?
            particles_per_automatic_tetrahedron :
            particles_per_automatic_hexahedron;
        return resolution;
      }
    if (silo.shape == SceneParameters::Shape::silo)
      {
        if (silo.cell_type == CellType::triangle)
          resolution = resolution_of_triangles(silo, wave_speed);
        else
          resolution.element_size = rounded(size_of_squares(silo));
      }
    resolution.particles_per_cell = particles_per_automatic_cell;
    return resolution;
  }
} // namespace Sandglass
