#include <sandglass/base/exceptions.h>
#include <sandglass/base/parameter_entries.h>
#include <sandglass/scene/scene_parameters.h>

#include <cmath>
#include <filesystem>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    std::string
    to_text(const double value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }



    /// Lengths that differ by less of the half width are the same.
    constexpr double rounding = 1e-9;



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
                         to_text(scene.outlet_half_width),
                         std::string("allowed is ") +
                           (has_hopper ? "with a hopper less than" :
                                         "at most") +
                           " the silo's Half width of " + to_text(half_width) +
                           " m");
      if (!has_hopper && scene.wall_height == 0.)
        throw InputError("Scene",
                         "Wall height",
                         to_text(scene.wall_height),
                         "allowed is a number greater than 0, since there is "
                         "no hopper either (Hopper height = 0)");
    }
  } // namespace



  SceneParameters::SceneParameters()
    : ParameterAcceptor("Scene")
  {
    using Bounds = BoundedNumber;

    add_selection<Formulation>(
      *this,
      "Formulation",
      formulation,
      {{"plane strain", Formulation::plane_strain},
       {"axisymmetric", Formulation::axisymmetric}},
      "How the section extends to three dimensions: along z, with all results "
      "per metre of depth, or turned about the axis x = 0.");
    add_selection<Shape>(
      *this,
      "Shape",
      shape,
      {{"silo", Shape::silo}, {"mesh file", Shape::mesh_file}},
      "Where the mesh comes from: the silo's section described by the lengths "
      "below, or a file.");
    add_text(*this,
             "Mesh file",
             mesh_file,
             dealii::Patterns::FileName(dealii::Patterns::FileName::input),
             "Mesh in Gmsh's format, for Shape = mesh file. Physical lines "
             "axis, wall, floor, hopper, outlet, fall_side, fall_bottom, top, "
             "and further walls that Walls/Friction angles names; "
             "physical surfaces material and fall_region. It is moved so "
             "that the axis is at x = 0 and the outlet level at y = 0.");
    add_number(
      *this,
      "Half width",
      half_width,
      Bounds::greater_than(0.),
      "m",
      "Half width (plane strain) or radius (axisymmetric) of the silo.");
    add_number(*this,
               "Wall height",
               wall_height,
               Bounds::at_least(0.),
               "m",
               "Height of the vertical wall; the material fills it. With a "
               "hopper it may be 0: then there is no such wall.");
    add_number(*this,
               "Outlet half width",
               outlet_half_width,
               Bounds::greater_than(0.),
               "m",
               "Half width or radius of the outlet. With a flat bottom it may "
               "be the Half width: then there is no floor.");
    add_flag(
      *this,
      "Symmetry",
      is_symmetric,
      "Whether the half section right of the middle x = 0 stands for the "
      "silo, or the whole section from wall to wall is meshed "
      "(Formulation = plane strain only). For Shape = silo; a mesh file "
      "is half a section if it has an axis.");
    add_number(*this,
               "Outlet eccentricity",
               outlet_eccentricity,
               Bounds::any(),
               "m",
               "How far right of the silo's middle the middle of the outlet "
               "lies; other than 0 with Symmetry = false only.");
    add_number(*this,
               "Hopper height",
               hopper_height,
               Bounds::at_least(0.),
               "m",
               "Height of the hopper below the vertical wall; 0 gives a flat "
               "bottom.");
    add_number(*this,
               "Fall region depth",
               fall_region_depth,
               Bounds::greater_than(0.),
               "m",
               "Depth of the region below an open outlet in which material "
               "falls before it is removed.");
    add_number(*this,
               "Element size",
               element_size,
               Bounds::greater_than(0.),
               "m",
               "Edge length of the cells.");
    add_number(*this,
               "Outlet element size",
               outlet_element_size,
               Bounds::at_least(0.),
               "m",
               "Edge length of the cells at the outlet's lip, which grows by "
               "0.2 of the distance from there up to Element size (Cell type "
               "= triangle only); 0 takes Element size everywhere.");
    add_selection<MeshAlgorithm>(
      *this,
      "Mesh algorithm",
      mesh_algorithm,
      {{"Frontal-Delaunay", MeshAlgorithm::frontal_delaunay},
       {"Delaunay", MeshAlgorithm::delaunay},
       {"MeshAdapt", MeshAlgorithm::mesh_adapt}},
      "Gmsh's algorithm for triangles; quadrilaterals are structured.");
    add_integer(*this,
                "Mesh seed",
                mesh_seed,
                1,
                1000000,
                "Seed of Gmsh's random numbers.");
    add_selection<CellType>(*this,
                            "Cell type",
                            cell_type,
                            {{"triangle", CellType::triangle},
                             {"quadrilateral", CellType::quadrilateral}},
                            "Shape of the cells.");
    add_selection<unsigned int>(
      *this,
      "Particles per cell",
      particles_per_cell,
      {{"1", 1},
       {"4", 4},
       {"9", 9},
       {"16", 16},
       {"25", 25},
       {"36", 36},
       {"64", 64}},
      "Material points in each filled cell: the centroids of equal parts into "
      "which the cell's edges are divided.");
    add_selection<bool>(*this,
                        "Outlet",
                        outlet_is_open,
                        {{"open", true}, {"closed", false}},
                        "Whether material can leave; a closed outlet belongs "
                        "to the floor, and there is no fall region: that of a "
                        "mesh file is left out.");
    add_selection<Partitioner>(
      *this,
      "Partitioner",
      partitioner,
      {{"METIS", Partitioner::metis}, {"p4est", Partitioner::p4est}},
      "What shares the cells out between ranks: METIS by their graph, p4est "
      "(Cell type = quadrilateral only) by cutting deal.II's hierarchical "
      "order of them into parts of equal weight.");
    add_parameter("Gravity",
                  gravity,
                  "Acceleration of gravity, x and y. Units: m/s^2.",
                  prm,
                  dealii::Patterns::List(dealii::Patterns::Double(), 2, 2));
  }



  void
  SceneParameters::check() const
  {
    if (partitioner == Partitioner::p4est && cell_type == CellType::triangle)
      throw InputError("Scene",
                       "Partitioner",
                       "p4est",
                       "allowed is METIS with Cell type = triangle; p4est "
                       "knows quadrilaterals only");
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
    check_symmetry();
    check_openings(*this);
    check_element_size();
  }



  void
  SceneParameters::check_element_size() const
  {
    const double at_lip = is_graded() ? outlet_element_size : element_size;
    if (at_lip > outlet_half_width)
      throw InputError("Scene",
                       is_graded() ? "Outlet element size" : "Element size",
                       to_text(at_lip),
                       "allowed is at most the Outlet half width of " +
                         to_text(outlet_half_width) +
                         " m, which must hold an element");
    const bool   has_wall = wall_height > 0.;
    const double height   = has_wall ? wall_height : hopper_height;
    if (element_size > height)
      throw InputError("Scene",
                       "Element size",
                       to_text(element_size),
                       std::string("allowed is at most the ") +
                         (has_wall ? "Wall height of " : "Hopper height of ") +
                         to_text(height) + " m");
    if (outlet_element_size > element_size)
      throw InputError("Scene",
                       "Outlet element size",
                       to_text(outlet_element_size),
                       "allowed is at most the Element size of " +
                         to_text(element_size) + " m");
    if (is_graded() && cell_type == CellType::quadrilateral)
      throw InputError("Scene",
                       "Outlet element size",
                       to_text(outlet_element_size),
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
                       to_text(outlet_eccentricity),
                       "allowed is 0, since Symmetry = true; an eccentric "
                       "outlet needs Symmetry = false");
    if (outlet_half_width <= half_width * (1. + rounding) &&
        std::abs(outlet_eccentricity) + outlet_half_width >
          half_width * (1. + rounding))
      throw InputError("Scene",
                       "Outlet eccentricity",
                       to_text(outlet_eccentricity),
                       "the outlet must lie between the walls: allowed is at "
                       "most " +
                         to_text(half_width - outlet_half_width) +
                         " m to either side, the Half width less the Outlet "
                         "half width");
  }
} // namespace Sandglass
