#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/check_mesh.h>
#include <sandglass/scene/fill_layers.h>
#include <sandglass/scene/fill_surface.h>
#include <sandglass/scene/gmsh_mesh.h>
#include <sandglass/scene/gmsh_options.h>
#include <sandglass/scene/headroom.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/scene/merge_vertices.h>
#include <sandglass/scene/mesh_cells.h>
#include <sandglass/scene/mesh_outlet.h>
#include <sandglass/scene/name_faces.h>
#include <sandglass/scene/place_mesh.h>
#include <sandglass/scene/section_surface.h>
#include <sandglass/scene/silo_section.h>

#include <gmsh.h>

#include <string>

namespace Sandglass
{
  namespace
  {
    [[noreturn]] void
    refuse_file(const SceneParameters &parameters, const std::string &what)
    {
      throw InputError("Scene", "Mesh file", parameters.mesh_file, what);
    }



    /// The mesh of Gmsh's current model.
    template <int dim>
    Mesh<dim>
    take_mesh(const SceneParameters    &parameters,
              std::vector<std::string> &warnings)
    {
      GmshMesh     gmsh_mesh = read_gmsh_model();
      Mesh<dim>    mesh      = take_cells<dim>(gmsh_mesh, parameters.cell_type);
      unsigned int n_merged  = merge_vertices(mesh, gmsh_mesh);
      orient_cells(mesh);
      check_overlap(mesh);
      if (!parameters.outlet_is_open)
        leave_out_fall_region(mesh, gmsh_mesh);
      name_faces(mesh, gmsh_mesh, parameters.outlet_is_open, warnings);
      place_mesh(mesh, parameters.formulation, warnings);
      if (gmsh_mesh.is_of_higher_order)
        warnings.push_back("The mesh's cells are of higher order: only their "
                           "corners are used, and their edges are straight.");
      if (n_merged > 0)
        warnings.push_back(
          "Surfaces of the mesh meet without sharing their nodes: " +
          std::to_string(n_merged) + " nodes have been merged.");
      return mesh;
    }
  } // namespace



  template <>
  Mesh<2>
  mesh_silo<2>(const SceneParameters &parameters)
  {
    const SectionSurface filling = section_surface(parameters);
    GmshSession          session;
    try
      {
        call_gmsh([&]() {
          add_silo_section(parameters, filling);
          set_gmsh_options(parameters);
          gmsh::model::mesh::generate(2);
        });
      }
    catch (const std::exception &error)
      {
        throw InputError("Gmsh can't mesh the silo (" +
                           std::string(error.what()) +
                           "); try another Element size, Mesh algorithm or "
                           "Mesh seed",
                         "Scene",
                         "Element size");
      }
    std::vector<std::string> warnings;
    if (parameters.cell_type == CellType::triangle)
      return take_mesh<2>(parameters, warnings);
    try
      {
        return take_mesh<2>(parameters, warnings);
      }
    catch (const InputError &error)
      {
        throw InputError("Scene",
                         "Cell type",
                         "quadrilateral",
                         "its structured cells don't fit the silo and its "
                         "surface (" +
                           std::string(error.what()) +
                           "); allowed is triangle here");
      }
  }



  template <int dim>
  Mesh<dim>
  read_mesh(const SceneParameters    &parameters,
            std::vector<std::string> &warnings)
  {
    GmshSession session;
    try
      {
        call_gmsh([&parameters]() { gmsh::open(parameters.mesh_file); });
      }
    catch (const std::exception &error)
      {
        refuse_file(parameters,
                    "Gmsh can't read it (" + std::string(error.what()) +
                      "); allowed is a mesh in Gmsh's .msh format");
      }
    try
      {
        return take_mesh<dim>(parameters, warnings);
      }
    catch (const InputError &error)
      {
        refuse_file(parameters, error.what());
      }
  }



  template <int dim>
  Mesh<dim>
  make_mesh(const SceneParameters    &parameters,
            const MPI_Comm            communicator,
            std::vector<std::string> *warnings)
  {
    using namespace dealii;
    std::vector<std::string> found;
    // Errors travel with the mesh, so that each rank throws the same one.
    std::pair<Mesh<dim>, std::array<std::string, 3>> result;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          result.first = parameters.shape == SceneParameters::Shape::silo ?
                           mesh_silo<dim>(parameters) :
                           read_mesh<dim>(parameters, found);
          check_gravity(parameters, result.first);
          add_headroom(result.first,
                       parameters.headroom_height() +
                         space_above<dim>(parameters));
          fill_to_surface(result.first, parameters);
          if (parameters.is_filled_in_layers)
            fit_layers(result.first, parameters.n_layers);
          sort_along_curve(result.first);
          doubt_lengths(result.first, found);
          doubt_outlet(parameters, result.first, found);
        }
      catch (const InputError &error)
        {
          result.second = {{error.what(), error.section, error.name}};
        }
    if (Utilities::MPI::n_mpi_processes(communicator) > 1)
      result = Utilities::MPI::broadcast(communicator, result);
    const auto &[message, section, name] = result.second;
    if (!message.empty())
      throw InputError(message, section, name);
    if (warnings != nullptr)
      *warnings = std::move(found);
    return result.first;
  }



#define INSTANTIATE(dim)                                         \
  template Mesh<dim> read_mesh<dim>(const SceneParameters &,     \
                                    std::vector<std::string> &); \
  template Mesh<dim> make_mesh<dim>(const SceneParameters &,     \
                                    const MPI_Comm,              \
                                    std::vector<std::string> *);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
