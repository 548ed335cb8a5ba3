#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/choices.h>
#include <sandglass/scene/make_mesh.h>
#include <sandglass/scene/make_walls.h>
#include <sandglass/scene/silo_section.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace Sandglass
{
  namespace
  {
    /// Keeps Gmsh open for a scope, with its messages silenced.
    class GmshSession
    {
    public:
      GmshSession()
      {
        gmsh::initialize(0, nullptr, false);
        gmsh::option::setNumber("General.Terminal", 0);
      }

      GmshSession(const GmshSession &) = delete;

      ~GmshSession()
      {
        gmsh::finalize();
      }
    };



    void
    generate(const SceneParameters &parameters, const int dimension)
    {
      const int algorithm =
        parameters.mesh_algorithm ==
            SceneParameters::MeshAlgorithm::frontal_delaunay ?
          6 :
        parameters.mesh_algorithm == SceneParameters::MeshAlgorithm::delaunay ?
          5 :
          1;
      gmsh::option::setNumber("Mesh.Algorithm", algorithm);
      gmsh::option::setNumber("Mesh.RandomSeed", parameters.mesh_seed);
      gmsh::model::mesh::generate(dimension);
    }



    template <int dim>
    void
    take_vertices(Mesh<dim>                           &mesh,
                  std::map<std::size_t, unsigned int> &index_of)
    {
      std::vector<std::size_t> tags;
      std::vector<double>      coordinates, unused;
      gmsh::model::mesh::getNodes(tags, coordinates, unused);
      for (std::size_t i = 0; i < tags.size(); ++i)
        if (index_of.emplace(tags[i], mesh.vertices.size()).second)
          {
            dealii::Point<dim> vertex;
            for (unsigned int d = 0; d < dim; ++d)
              vertex[d] = coordinates[3 * i + d];
            mesh.vertices.push_back(vertex);
          }
    }



    /// Node tags of the elements of one type in a physical group, in a row.
    std::vector<std::size_t>
    element_nodes(const int dimension, const int group, const int element_type)
    {
      std::vector<int> entities;
      gmsh::model::getEntitiesForPhysicalGroup(dimension, group, entities);
      std::vector<std::size_t> all_nodes;
      for (const int entity : entities)
        {
          std::vector<std::size_t> tags, nodes;
          gmsh::model::mesh::getElementsByType(element_type,
                                               tags,
                                               nodes,
                                               entity);
          all_nodes.insert(all_nodes.end(), nodes.begin(), nodes.end());
        }
      return all_nodes;
    }



    /// Gmsh's number of the element type with so many nodes in a dimension.
    int
    gmsh_type(const int dimension, const unsigned int n_nodes)
    {
      const std::string names[]{"", "Line", "Triangle", "Tetrahedron"};
      const std::string cubes[]{"", "Line", "Quadrangle", "Hexahedron"};
      const bool        is_simplex =
        n_nodes == static_cast<unsigned int>(dimension) + 1;
      return gmsh::model::mesh::getElementType(is_simplex ? names[dimension] :
                                                            cubes[dimension],
                                               1);
    }



    /// Add the faces of a physical group, one of the standard parts or else a
    /// named wall.
    template <int dim>
    void
    take_faces(Mesh<dim>                                 &mesh,
               const std::map<std::size_t, unsigned int> &index_of,
               const int                                  group,
               const std::string                         &name)
    {
      typename Mesh<dim>::Face face{{}, BoundaryRole::insert};
      const auto               part =
        std::find(boundary_role_names.begin(), boundary_role_names.end(), name);
      if (part != boundary_role_names.end())
        face.role =
          static_cast<BoundaryRole>(part - boundary_role_names.begin() + 1);
      else
        {
          face.named_wall = mesh.named_walls.size();
          mesh.named_walls.push_back(name);
        }

      const unsigned int n = mesh.vertices_per_face();
      const auto nodes = element_nodes(dim - 1, group, gmsh_type(dim - 1, n));
      for (std::size_t i = 0; i < nodes.size(); i += n)
        {
          for (unsigned int v = 0; v < n; ++v)
            face.vertices[v] = index_of.at(nodes[i + v]);
          mesh.faces.push_back(face);
        }
    }



    /// Read what Gmsh's current model holds into a Mesh.
    template <int dim>
    Mesh<dim>
    take_mesh(const CellType cell_type)
    {
      Mesh<dim> mesh;
      mesh.cell_type = cell_type;
      std::map<std::size_t, unsigned int> index_of;
      take_vertices(mesh, index_of);

      gmsh::vectorpair groups;
      gmsh::model::getPhysicalGroups(groups);
      for (const auto &[dimension, group] : groups)
        {
          std::string name;
          gmsh::model::getPhysicalName(dimension, group, name);
          if (dimension == dim - 1 && !name.empty())
            take_faces(mesh, index_of, group, name);
          else if (dimension == dim &&
                   (name == material_group || name == fall_region_group))
            {
              const unsigned int n = mesh.vertices_per_cell();
              const auto         nodes =
                element_nodes(dimension, group, gmsh_type(dimension, n));
              for (std::size_t i = 0; i < nodes.size(); i += n)
                {
                  typename Mesh<dim>::Cell cell{{}, name == material_group};
                  for (unsigned int v = 0; v < n; ++v)
                    cell.vertices[v] = index_of.at(nodes[i + v]);
                  mesh.cells.push_back(cell);
                }
            }
        }
      settle_named_walls(mesh);
      return mesh;
    }



    template <int dim>
    void
    check_mesh_file(const Mesh<dim> &mesh, const std::string &filename)
    {
      const auto refuse = [&filename](const std::string &what) {
        throw InputError("Scene", "Mesh file", filename, what);
      };
      if (std::none_of(mesh.cells.begin(),
                       mesh.cells.end(),
                       [](const typename Mesh<dim>::Cell &cell) {
                         return cell.is_filled;
                       }))
        refuse(std::string("the mesh has no ") +
               (mesh.cell_type == CellType::triangle ? "triangles" :
                                                       "quadrilaterals") +
               " in a physical surface named 'material'; allowed are meshes "
               "with the surfaces 'material' and, below an open outlet, "
               "'fall_region'");
      for (const BoundaryRole role : {BoundaryRole::outlet, BoundaryRole::wall})
        if (std::none_of(mesh.faces.begin(),
                         mesh.faces.end(),
                         [role](const typename Mesh<dim>::Face &edge) {
                           return edge.role == role;
                         }))
          refuse("the mesh has no physical line named '" +
                 std::string(name_of(role)) +
                 "'; allowed are meshes that name their boundary: axis, wall, "
                 "floor, hopper, outlet, fall_side, fall_bottom, top");
    }
  } // namespace



  template <>
  Mesh<2>
  mesh_silo<2>(const SceneParameters &parameters)
  {
    GmshSession session;
    add_silo_section(parameters);
    generate(parameters, 2);
    return take_mesh<2>(parameters.cell_type);
  }



  template <int dim>
  Mesh<dim>
  read_mesh(const std::string &filename, const CellType cell_type)
  {
    GmshSession session;
    try
      {
        gmsh::open(filename);
      }
    catch (const std::exception &error)
      {
        throw InputError("Scene",
                         "Mesh file",
                         filename,
                         "Gmsh can't read it (" + std::string(error.what()) +
                           "); allowed is a mesh in Gmsh's .msh format");
      }
    Mesh<dim> mesh = take_mesh<dim>(cell_type);
    check_mesh_file(mesh, filename);
    return mesh;
  }



  template <int dim>
  Mesh<dim>
  make_mesh(const SceneParameters &parameters, const MPI_Comm communicator)
  {
    using namespace dealii;
    // Errors travel with the mesh, so that each rank throws the same one.
    std::pair<Mesh<dim>, std::array<std::string, 3>> result;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          result.first =
            parameters.shape == SceneParameters::Shape::silo ?
              mesh_silo<dim>(parameters) :
              read_mesh<dim>(parameters.mesh_file, parameters.cell_type);
          sort_along_curve(result.first);
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
    return result.first;
  }



#define INSTANTIATE(dim)                                                  \
  template Mesh<dim> read_mesh<dim>(const std::string &, const CellType); \
  template Mesh<dim> make_mesh<dim>(const SceneParameters &, const MPI_Comm);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
