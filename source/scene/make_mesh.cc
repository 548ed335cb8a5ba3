#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/scene/make_mesh.h>

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace Sandglass
{
  namespace
  {
    const std::string material_group    = "material";
    const std::string fall_region_group = "fall_region";

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



    /**
     * Builds the silo's section from corner points, straight lines and plane
     * surfaces, and remembers the names of what it builds.
     */
    class SiloGeometry
    {
    public:
      explicit SiloGeometry(const SceneParameters &parameters)
        : parameters(parameters)
      {
        gmsh::model::add("silo");
        if (parameters.cell_type == CellType::triangle)
          add_outlines();
        else
          add_blocks();
        gmsh::model::geo::synchronize();
        for (const auto &[name, lines] : lines_named)
          gmsh::model::setPhysicalName(1,
                                       gmsh::model::addPhysicalGroup(1, lines),
                                       name);
        for (const auto &[name, surfaces] : surfaces_named)
          gmsh::model::setPhysicalName(
            2, gmsh::model::addPhysicalGroup(2, surfaces), name);
      }

    private:
      int
      point(const double x, const double y)
      {
        return gmsh::model::geo::addPoint(x, y, 0., parameters.element_size);
      }

      int
      line(const int start, const int end, const BoundaryRole role)
      {
        const int tag = gmsh::model::geo::addLine(start, end);
        lines_named[std::string(name_of(role))].push_back(tag);
        return tag;
      }

      int
      surface(const std::vector<int> &lines, const std::string &name)
      {
        const int tag = gmsh::model::geo::addPlaneSurface(
          {gmsh::model::geo::addCurveLoop(lines)});
        surfaces_named[name].push_back(tag);
        return tag;
      }

      /// Free triangles: one surface for the silo, one for the fall region.
      void
      add_outlines()
      {
        const double a = parameters.half_width;
        const double c = parameters.outlet_half_width;
        const double e = parameters.hopper_height;

        const int outlet_axis = point(0., 0.);
        const int lip         = point(c, 0.);
        const int wall_foot   = point(a, e);
        const int wall_top    = point(a, parameters.fill_height());
        const int axis_top    = point(0., parameters.fill_height());

        const int outlet = line(outlet_axis, lip, BoundaryRole::outlet);
        surface({outlet,
                 line(lip,
                      wall_foot,
                      e > 0. ? BoundaryRole::hopper : BoundaryRole::floor),
                 line(wall_foot, wall_top, BoundaryRole::wall),
                 line(wall_top, axis_top, BoundaryRole::top),
                 line(axis_top, outlet_axis, BoundaryRole::axis)},
                material_group);

        if (!parameters.outlet_is_open)
          return;
        const int axis_bottom = point(0., -parameters.fall_region_depth);
        const int side_bottom = point(c, -parameters.fall_region_depth);
        surface({-outlet,
                 line(outlet_axis, axis_bottom, BoundaryRole::axis),
                 line(axis_bottom, side_bottom, BoundaryRole::fall_bottom),
                 line(side_bottom, lip, BoundaryRole::fall_side)},
                fall_region_group);
      }

      int
      inner_line(const int start, const int end)
      {
        return gmsh::model::geo::addLine(start, end);
      }

      unsigned int
      n_cells_along(const double length) const
      {
        return std::max(1., std::round(length / parameters.element_size));
      }

      /// A surface of n x m quadrilaterals between four lines.
      void
      block(const int          bottom,
            const int          right,
            const int          top,
            const int          left,
            const unsigned int n,
            const unsigned int m,
            const std::string &name)
      {
        const int tag = surface({bottom, right, top, left}, name);
        for (const int curve : {bottom, top})
          gmsh::model::geo::mesh::setTransfiniteCurve(std::abs(curve), n + 1);
        for (const int curve : {right, left})
          gmsh::model::geo::mesh::setTransfiniteCurve(std::abs(curve), m + 1);
        gmsh::model::geo::mesh::setTransfiniteSurface(tag);
        gmsh::model::geo::mesh::setRecombine(2, tag);
      }

      /// Structured quadrilaterals: blocks between the outlet's and the
      /// hopper's corners.
      void
      add_blocks()
      {
        const double a = parameters.half_width;
        const double c = parameters.outlet_half_width;
        const double e = parameters.hopper_height;
        const double h = parameters.fill_height();

        const unsigned int n_outlet = n_cells_along(c);
        const unsigned int n_height = n_cells_along(parameters.wall_height);

        const int outlet_axis = point(0., 0.), lip = point(c, 0.);
        const int outlet   = line(outlet_axis, lip, BoundaryRole::outlet);
        const int axis_top = point(0., h), wall_top = point(a, h);

        if (e > 0.)
          {
            const unsigned int n_width =
              std::max(n_outlet, n_cells_along((a + c) / 2.));
            const unsigned int n_hopper = n_cells_along(std::hypot(e, a - c));
            n_columns_below             = n_width;

            const int wall_foot = point(a, e), axis_foot = point(0., e);
            const int transition = inner_line(axis_foot, wall_foot);
            block(outlet,
                  line(lip, wall_foot, BoundaryRole::hopper),
                  -transition,
                  line(axis_foot, outlet_axis, BoundaryRole::axis),
                  n_width,
                  n_hopper,
                  material_group);
            block(transition,
                  line(wall_foot, wall_top, BoundaryRole::wall),
                  line(wall_top, axis_top, BoundaryRole::top),
                  line(axis_top, axis_foot, BoundaryRole::axis),
                  n_width,
                  n_height,
                  material_group);
          }
        else
          {
            n_columns_below     = n_outlet;
            const int wall_foot = point(a, 0.), lip_top = point(c, h);
            const int above_lip = inner_line(lip, lip_top);
            block(outlet,
                  above_lip,
                  line(lip_top, axis_top, BoundaryRole::top),
                  line(axis_top, outlet_axis, BoundaryRole::axis),
                  n_outlet,
                  n_height,
                  material_group);
            block(line(lip, wall_foot, BoundaryRole::floor),
                  line(wall_foot, wall_top, BoundaryRole::wall),
                  line(wall_top, lip_top, BoundaryRole::top),
                  -above_lip,
                  n_cells_along(a - c),
                  n_height,
                  material_group);
          }

        if (!parameters.outlet_is_open)
          return;
        const int axis_bottom = point(0., -parameters.fall_region_depth);
        const int side_bottom = point(c, -parameters.fall_region_depth);
        block(line(axis_bottom, side_bottom, BoundaryRole::fall_bottom),
              line(side_bottom, lip, BoundaryRole::fall_side),
              -outlet,
              line(outlet_axis, axis_bottom, BoundaryRole::axis),
              n_columns_below,
              n_cells_along(parameters.fall_region_depth),
              fall_region_group);
      }

      const SceneParameters                  &parameters;
      std::map<std::string, std::vector<int>> lines_named, surfaces_named;
      unsigned int                            n_columns_below = 0;
    };



    void
    generate(const SceneParameters &parameters)
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
      gmsh::model::mesh::generate(2);
    }



    void
    take_vertices(Mesh &mesh, std::map<std::size_t, unsigned int> &index_of)
    {
      std::vector<std::size_t> tags;
      std::vector<double>      coordinates, unused;
      gmsh::model::mesh::getNodes(tags, coordinates, unused);
      for (std::size_t i = 0; i < tags.size(); ++i)
        if (index_of.emplace(tags[i], mesh.vertices.size()).second)
          mesh.vertices.emplace_back(coordinates[3 * i],
                                     coordinates[3 * i + 1]);
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



    constexpr int gmsh_line = 1, gmsh_triangle = 2, gmsh_quadrangle = 3;

    /// Read what Gmsh's current model holds into a Mesh.
    Mesh
    take_mesh(const CellType cell_type)
    {
      Mesh mesh;
      mesh.cell_type = cell_type;
      std::map<std::size_t, unsigned int> index_of;
      take_vertices(mesh, index_of);

      gmsh::vectorpair groups;
      gmsh::model::getPhysicalGroups(groups);
      for (const auto &[dimension, group] : groups)
        {
          std::string name;
          gmsh::model::getPhysicalName(dimension, group, name);
          if (dimension == 1)
            {
              const auto role = std::find(boundary_role_names.begin(),
                                          boundary_role_names.end(),
                                          name);
              if (role == boundary_role_names.end())
                continue;
              const auto nodes = element_nodes(1, group, gmsh_line);
              for (std::size_t i = 0; i < nodes.size(); i += 2)
                mesh.edges.push_back(
                  {{{index_of.at(nodes[i]), index_of.at(nodes[i + 1])}},
                   static_cast<BoundaryRole>(role -
                                             boundary_role_names.begin() + 1)});
            }
          else if (dimension == 2 &&
                   (name == material_group || name == fall_region_group))
            {
              const unsigned int n = mesh.vertices_per_cell();
              const auto         nodes =
                element_nodes(2,
                              group,
                              n == 3 ? gmsh_triangle : gmsh_quadrangle);
              for (std::size_t i = 0; i < nodes.size(); i += n)
                {
                  Mesh::Cell cell{{{0, 0, 0, 0}}, name == material_group};
                  for (unsigned int v = 0; v < n; ++v)
                    cell.vertices[v] = index_of.at(nodes[i + v]);
                  mesh.cells.push_back(cell);
                }
            }
        }
      return mesh;
    }



    void
    check_mesh_file(const Mesh &mesh, const std::string &filename)
    {
      const auto refuse = [&filename](const std::string &what) {
        throw InputError("Scene", "Mesh file", filename, what);
      };
      if (std::none_of(mesh.cells.begin(),
                       mesh.cells.end(),
                       [](const Mesh::Cell &cell) { return cell.is_filled; }))
        refuse(std::string("the mesh has no ") +
               (mesh.cell_type == CellType::triangle ? "triangles" :
                                                       "quadrilaterals") +
               " in a physical surface named 'material'; allowed are meshes "
               "with the surfaces 'material' and, below an open outlet, "
               "'fall_region'");
      for (const BoundaryRole role : {BoundaryRole::outlet, BoundaryRole::wall})
        if (std::none_of(mesh.edges.begin(),
                         mesh.edges.end(),
                         [role](const Mesh::Edge &edge) {
                           return edge.role == role;
                         }))
          refuse("the mesh has no physical line named '" +
                 std::string(name_of(role)) +
                 "'; allowed are meshes that name their boundary: axis, wall, "
                 "floor, hopper, outlet, fall_side, fall_bottom, top");
    }
  } // namespace



  Mesh
  mesh_silo(const SceneParameters &parameters)
  {
    GmshSession  session;
    SiloGeometry geometry(parameters);
    generate(parameters);
    return take_mesh(parameters.cell_type);
  }



  Mesh
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
    Mesh mesh = take_mesh(cell_type);
    check_mesh_file(mesh, filename);
    return mesh;
  }



  Mesh
  make_mesh(const SceneParameters &parameters, const MPI_Comm communicator)
  {
    using namespace dealii;
    // Errors travel with the mesh, so that each rank throws the same one.
    std::pair<Mesh, std::array<std::string, 3>> result;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          result.first =
            parameters.shape == SceneParameters::Shape::silo ?
              mesh_silo(parameters) :
              read_mesh(parameters.mesh_file, parameters.cell_type);
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
} // namespace Sandglass
