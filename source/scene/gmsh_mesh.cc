#include <sandglass/scene/gmsh_mesh.h>

#include <gmsh.h>

#include <algorithm>
#include <map>

namespace Sandglass
{
  namespace
  {
    /// How the names of nameless groups begin.
    constexpr char number[] = "number ";



    /// Collects the parts of a GmshMesh.
    class Reader
    {
    public:
      GmshMesh
      read()
      {
        read_nodes();
        gmsh::vectorpair entities;
        gmsh::model::getEntities(entities);
        for (const auto &[dimension, entity] : entities)
          if (dimension > 0)
            read_elements(dimension, entity);
        return std::move(mesh);
      }

    private:
      void
      read_nodes()
      {
        std::vector<std::size_t> tags;
        std::vector<double>      coordinates, unused;
        gmsh::model::mesh::getNodes(tags, coordinates, unused);
        for (std::size_t i = 0; i < tags.size(); ++i)
          if (index_of.emplace(tags[i], mesh.nodes.size()).second)
            mesh.nodes.emplace_back(coordinates[3 * i],
                                    coordinates[3 * i + 1],
                                    coordinates[3 * i + 2]);
      }

      std::set<std::string>
      groups_of(const int dimension, const int entity)
      {
        std::vector<int> groups;
        gmsh::model::getPhysicalGroupsForEntity(dimension, entity, groups);
        std::set<std::string> names;
        for (const int group : groups)
          {
            std::string name;
            // Partitions of a mesh turn the sign.
            gmsh::model::getPhysicalName(dimension, std::abs(group), name);
            if (name.empty())
              name = number + std::to_string(group);
            names.insert(name);
          }
        mesh.groups[dimension].insert(names.begin(), names.end());
        return names;
      }

      void
      read_elements(const int dimension, const int entity)
      {
        const std::set<std::string> groups = groups_of(dimension, entity);

        std::vector<int>                      types;
        std::vector<std::vector<std::size_t>> tags, nodes;
        gmsh::model::mesh::getElements(types, tags, nodes, dimension, entity);
        for (std::size_t t = 0; t < types.size(); ++t)
          {
            std::string         name;
            int                 unused, order, n_nodes, n_corners;
            std::vector<double> coordinates;
            gmsh::model::mesh::getElementProperties(
              types[t], name, unused, order, n_nodes, coordinates, n_corners);
            mesh.is_of_higher_order = mesh.is_of_higher_order || order > 1;
            for (std::size_t i = 0; i < nodes[t].size(); i += n_nodes)
              {
                GmshMesh::Element element{{}, name, groups};
                for (int v = 0; v < n_corners; ++v)
                  element.corners.push_back(index_of.at(nodes[t][i + v]));
                add(dimension, element);
              }
          }
      }

      /// A file may hold an element once for each of its groups.
      void
      add(const int dimension, const GmshMesh::Element &element)
      {
        auto &elements = mesh.elements[dimension];
        auto  sorted   = element.corners;
        std::sort(sorted.begin(), sorted.end());
        const auto [known, is_new] =
          element_with[dimension].emplace(sorted, elements.size());
        if (is_new)
          elements.push_back(element);
        else
          elements[known->second].groups.insert(element.groups.begin(),
                                                element.groups.end());
      }

      GmshMesh                            mesh;
      std::map<std::size_t, unsigned int> index_of; ///< by Gmsh's number
      /// Index of the element with these corners.
      std::array<std::map<std::vector<unsigned int>, std::size_t>, 4>
        element_with;
    };
  } // namespace



  GmshSession::GmshSession()
  {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
  }



  GmshSession::~GmshSession()
  {
    gmsh::finalize();
  }



  bool
  is_nameless(const std::string &group)
  {
    return group.rfind(number, 0) == 0;
  }



  GmshMesh
  read_gmsh_model()
  {
    return Reader().read();
  }
} // namespace Sandglass
