#include <sandglass/base/parameter_entries.h>
#include <sandglass/scene/automatic_mesh.h>
#include <sandglass/scene/fill_surface.h>
#include <sandglass/scene/scene_parameters.h>

namespace Sandglass
{
  SceneParameters::SceneParameters()
    : ParameterAcceptor("Scene")
  {
    using Bounds = BoundedNumber;

    add_selection<Formulation>(
      *this,
      "Formulation",
      formulation,
      {{"plane strain", Formulation::plane_strain},
       {"axisymmetric", Formulation::axisymmetric},
       {"three dimensions", Formulation::three_dimensions}},
      "How the section extends to three dimensions: along z, with all results "
      "per metre of depth, or turned about the axis x = 0; or three dimensions "
      "themselves, y upwards.");
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
             "physical surfaces material, fall_region, and space (empty above "
             "the material); in three dimensions, surfaces and volumes, and "
             "axis names the symmetry planes. It is "
             "moved so that axis or symmetry planes are at x = 0 and z = 0 and "
             "the outlet level at y = 0.");
    add_number(
      *this,
      "Half width",
      half_width,
      Bounds::greater_than(0.),
      "m",
      "Half width (plane strain), radius (axisymmetric, or Cross section = "
      "circle), or half length along x of the silo.");
    add_number(*this,
               "Wall height",
               wall_height,
               Bounds::at_least(0.),
               "m",
               "Height of the vertical wall. With a hopper it may be 0: then "
               "there is no such wall.");
    const OptionalNumber level_or_full(Bounds::greater_than(0.), "full");
    enter_my_subsection(prm);
    prm.declare_entry(
      "Fill height",
      "full",
      level_or_full,
      "Level of the material above the outlet at the start, or `full`: to the "
      "silo's top. Of a heap it is the level of the same volume between "
      "vertical walls. Units: m.");
    prm.add_action("Fill height",
                   [this, level_or_full](const std::string &text) {
                     fill_height = level_or_full.parse(text);
                   });
    leave_my_subsection(prm);
    add_selection<bool>(
      *this,
      "Filling",
      is_filled_in_layers,
      {{"at once", false}, {"in layers", true}},
      "How the state at rest comes about: all material gets its weight at the "
      "same time, or layers are placed on each other, each without stress in "
      "the configuration that those below it have under their weight "
      "(Flow/Method = particle-in-cell only).");
    add_integer(*this,
                "Layers",
                n_layers,
                1,
                1000,
                "Number of layers of equal height, for Filling = in layers.");
    add_number(*this,
               "Surface slope",
               surface_slope,
               Bounds::at_least_below(0., 90.),
               "degrees",
               "Angle by which the material's surface falls at the start from "
               "the silo's middle to its walls: 0 where it is level, the angle "
               "of repose of a heap.");
    add_number(
      *this,
      "Outlet half width",
      outlet_half_width,
      Bounds::greater_than(0.),
      "m",
      "Half width or radius of the outlet, along x. With a flat bottom "
      "it may be the Half width: then there is no floor.");
    add_flag(
      *this,
      "Symmetry",
      is_symmetric,
      "Whether the half section right of the middle x = 0 stands for the "
      "silo, or the whole section from wall to wall is meshed "
      "(Formulation = plane strain only; see Symmetry planes for three "
      "dimensions). For Shape = silo; a mesh file is half a section if it has "
      "an axis.");
    add_number(*this,
               "Outlet eccentricity",
               outlet_eccentricity,
               Bounds::any(),
               "m",
               "How far right of the silo's middle, along x, the middle of the "
               "outlet lies; other than 0 with Symmetry = false or in three "
               "dimensions only.");
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
    add_automatic_number(
      *this,
      "Headroom",
      headroom,
      Bounds::at_least(0.),
      "m",
      "Height of empty cells above the material, into which its surface may be "
      "thrown when the outlet opens; `auto`: a fifth of the half width where "
      "Element size is `auto`, Shape = silo and Fill height = full, else 0.");
    add_automatic_number(
      *this,
      "Element size",
      element_size,
      Bounds::greater_than(0.),
      "m",
      "Edge length of the cells; `auto`: chosen from the silo.");
    add_automatic_number(
      *this,
      "Outlet element size",
      outlet_element_size,
      Bounds::at_least(0.),
      "m",
      "Edge length of the cells at the outlet's lip, which grows by 0.2 of the "
      "distance from there up to Element size (other than Cell type = "
      "quadrilateral); 0 "
      "takes Element size everywhere; `auto`: chosen from the outlet where "
      "Element size is, else 0.");
    add_number(*this,
               "Refinement",
               refinement,
               Bounds::within(smallest_refinement, largest_refinement),
               "1",
               "Factor by which all cells become smaller, those of sizes given "
               "and of sizes chosen: 2 halves their edges, 0.5 doubles them. "
               "For Shape = silo.");
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
                             {"quadrilateral", CellType::quadrilateral},
                             {"tetrahedron", CellType::tetrahedron},
                             {"hexahedron", CellType::hexahedron}},
                            "Shape of the cells: in two dimensions triangle or "
                            "quadrilateral, in three tetrahedron or "
                            "hexahedron.");
    add_selection<std::optional<unsigned int>>(
      *this,
      "Particles per cell",
      particles_per_cell,
      {{automatic, std::nullopt},
       {"1", 1},
       {"4", 4},
       {"8", 8},
       {"9", 9},
       {"16", 16},
       {"25", 25},
       {"27", 27},
       {"36", 36},
       {"64", 64}},
      "Material points in each filled cell: the centroids of equal parts into "
      "which the cell's edges are divided, a square number in two dimensions "
      "and a cube in three; `auto`: in two 9 where Element size is `auto` too, "
      "else 4; in three 8 in tetrahedra, 27 in hexahedra.");
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
      "(quadrilaterals and hexahedra only) by cutting deal.II's hierarchical "
      "order of them into parts of equal weight.");
    add_parameter(
      "Gravity",
      gravity,
      "Acceleration of gravity, x and y, and z in three dimensions. "
      "Units: m/s^2.",
      prm,
      dealii::Patterns::List(dealii::Patterns::Double(), 2, 3));
    declare_body();
  }



  Resolution
  SceneParameters::unrefined_resolution(const double wave_speed) const
  {
    const Resolution chosen = automatic_resolution(*this, wave_speed);
    if (!element_size)
      return {chosen.element_size,
              outlet_element_size.value_or(chosen.outlet_element_size),
              particles_per_cell.value_or(chosen.particles_per_cell)};
    const bool has_own_cells = shape == Shape::mesh_file;
    return {has_own_cells ? chosen.element_size : *element_size,
            has_own_cells ? 0. : outlet_element_size.value_or(0.),
            particles_per_cell.value_or(formulation ==
                                            Formulation::three_dimensions ?
                                          chosen.particles_per_cell :
                                          particles_per_given_cell)};
  }



  Resolution
  SceneParameters::resolution() const
  {
    Resolution result = unrefined_resolution(0.);
    result.element_size /= refinement;
    result.outlet_element_size /= refinement;
    return result;
  }



  double
  SceneParameters::headroom_height() const
  {
    const bool is_automatic = shape == Shape::silo && !element_size;
    return headroom.value_or(
      is_automatic && is_full(*this) ? automatic_headroom(*this) : 0.);
  }



  void
  SceneParameters::fix_resolution(const double wave_speed)
  {
    const Resolution resolution = unrefined_resolution(wave_speed);
    if (!headroom)
      set_parameter("Scene", "Headroom", headroom_height());
    if (shape == Shape::silo && !outlet_element_size)
      set_parameter("Scene",
                    "Outlet element size",
                    resolution.outlet_element_size);
    if (shape == Shape::silo && !element_size)
      set_parameter("Scene", "Element size", resolution.element_size);
    if (!particles_per_cell)
      set_parameter("Scene",
                    "Particles per cell",
                    static_cast<long int>(resolution.particles_per_cell));
  }
} // namespace Sandglass
