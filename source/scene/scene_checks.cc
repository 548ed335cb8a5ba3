// What SceneParameters refuses.

#include <sandglass/base/exceptions.h>
#include <sandglass/base/number_text.h>
#include <sandglass/scene/scene_parameters.h>

#include <cmath>
#include <filesystem>

namespace Sandglass
{
  namespace
  {
    /// Lengths that differ by less of the half width are the same.
    constexpr double rounding = 1e-9;



    /**
     * Refuse a size of cells, and blame the parameter that it comes from: its
     * own, or the refinement where the program has chosen the size.
     *
     * @param is_at_lip  whether it is that of the cells at the outlet's lip.
     */
    [[noreturn]] void
    refuse_size(const SceneParameters &scene,
                const bool             is_at_lip,
                const std::string     &allowed)
    {
      const bool is_given_at_lip = scene.outlet_element_size.value_or(0.) > 0.;
      const bool blames_lip =
        is_given_at_lip && (is_at_lip || !scene.element_size);
      const std::optional<double> size =
        blames_lip ? scene.outlet_element_size : scene.element_size;
      if (!size)
        throw InputError("Scene",
                         "Refinement",
                         number_text(scene.refinement),
                         "the cells' size, which is chosen from the silo, "
                         "becomes too large: " +
                           allowed);
      throw InputError("Scene",
                       blames_lip ? "Outlet element size" : "Element size",
                       number_text(*size),
                       allowed + (scene.refinement == 1. ?
                                    "" :
                                    ", after division by Refinement = " +
                                      number_text(scene.refinement)));
    }



    /// Refuse an outlet wider than the silo, and a hopper that doesn't narrow.
    void
    check_openings(const SceneParameters &scene)
    {
      const bool   has_hopper = scene.hopper_height > 0.;
      const double half_width = scene.half_width;
      if (scene.outlet_half_width > half_width * (1. + rounding) ||
          (has_hopper &&
           scene.outlet_half_width > half_width * (1. - rounding)))
        throw InputError("Scene",
                         "Outlet half width",
                         number_text(scene.outlet_half_width),
                         std::string("allowed is ") +
                           (has_hopper ? "with a hopper less than" :
                                         "at most") +
                           " the silo's Half width of " +
                           number_text(half_width) + " m");
      if (!has_hopper && scene.wall_height == 0.)
        throw InputError("Scene",
                         "Wall height",
                         number_text(scene.wall_height),
                         "allowed is a number greater than 0, since there is "
                         "no hopper either (Hopper height = 0)");
    }
  } // namespace



  void
  SceneParameters::check() const
  {
    check_body();
    if (partitioner == Partitioner::p4est && is_simplex(cell_type))
      throw InputError("Scene",
                       "Partitioner",
                       "p4est",
                       cell_type == CellType::triangle ?
                         "allowed is METIS with Cell type = triangle; p4est "
                         "knows quadrilaterals only" :
                         "allowed is METIS with Cell type = tetrahedron; p4est "
                         "knows hexahedra only");
    if (shape == Shape::mesh_file)
      {
        if (mesh_file.empty())
          throw InputError("Scene",
                           "Mesh file",
                           mesh_file,
                           "allowed is the path of a mesh, since Shape = mesh "
                           "file");
        if (!std::filesystem::is_regular_file(mesh_file))
          throw InputError("Scene",
                           "Mesh file",
                           mesh_file,
                           "there is no such file; allowed is the path of a "
                           "mesh that Gmsh reads, relative to the working "
                           "directory");
        return;
      }
    if (formulation != Formulation::three_dimensions)
      check_symmetry();
    check_openings(*this);
    check_element_size();
  }



  void
  SceneParameters::check_element_size() const
  {
    const Resolution sizes = resolution();
    if (sizes.smallest_size() > outlet_half_width)
      refuse_size(*this,
                  sizes.is_graded(),
                  "allowed is at most the Outlet half width of " +
                    number_text(outlet_half_width) +
                    " m, which must hold an element");
    const bool   has_wall = wall_height > 0.;
    const double height   = has_wall ? wall_height : hopper_height;
    if (sizes.element_size > height)
      refuse_size(*this,
                  false,
                  std::string("allowed is at most the ") +
                    (has_wall ? "Wall height of " : "Hopper height of ") +
                    number_text(height) + " m");
    if (sizes.outlet_element_size > sizes.element_size)
      refuse_size(*this,
                  true,
                  "allowed is at most the Element size of " +
                    number_text(sizes.element_size) + " m");
    if (sizes.is_graded() && cell_type == CellType::quadrilateral)
      refuse_size(*this,
                  true,
                  "allowed is 0 with Cell type = quadrilateral, since "
                  "quadrilaterals are structured");
  }



  void
  SceneParameters::check_symmetry() const
  {
    if (!is_symmetric && formulation == Formulation::axisymmetric)
      throw InputError("Scene",
                       "Symmetry",
                       "false",
                       "allowed is true, since Formulation = axisymmetric "
                       "turns a half section about its axis");
    if (is_symmetric && outlet_eccentricity != 0.)
      throw InputError("Scene",
                       "Outlet eccentricity",
                       number_text(outlet_eccentricity),
                       "allowed is 0, since Symmetry = true; an eccentric "
                       "outlet needs Symmetry = false");
    if (outlet_half_width <= half_width * (1. + rounding) &&
        std::abs(outlet_eccentricity) + outlet_half_width >
          half_width * (1. + rounding))
      throw InputError("Scene",
                       "Outlet eccentricity",
                       number_text(outlet_eccentricity),
                       "the outlet must lie between the walls: allowed is at "
                       "most " +
                         number_text(half_width - outlet_half_width) +
                         " m to either side, the Half width less the Outlet "
                         "half width");
  }
} // namespace Sandglass
