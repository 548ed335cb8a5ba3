#include <sandglass/scene/mesh_faces.h>
#include <sandglass/scene/mesh_outlet.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace Sandglass
{
  namespace
  {
    using Edge = std::pair<unsigned int, unsigned int>;

    constexpr double infinity = std::numeric_limits<double>::infinity();



    /// Edge number `v` of a face, from its vertex with the smaller index.
    Edge
    edge_of(const Mesh<3>       &mesh,
            const Mesh<3>::Face &face,
            const unsigned int   v)
    {
      const unsigned int n = mesh.vertices_per_face();
      return std::minmax(face.vertices[v], face.vertices[(v + 1) % n]);
    }



    template <typename IsOfKind>
    std::set<Edge>
    edges_of(const Mesh<3> &mesh, const IsOfKind &is_of_kind)
    {
      std::set<Edge> edges;
      for (const auto &face : mesh.faces)
        if (is_of_kind(face.role))
          for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
            edges.insert(edge_of(mesh, face, v));
      return edges;
    }



    /// For each face a number that faces which hang together share.
    std::vector<unsigned int>
    connected_parts(const Mesh<3>                    &mesh,
                    const std::vector<Mesh<3>::Face> &faces)
    {
      std::map<Edge, std::vector<unsigned int>> faces_at;
      for (unsigned int i = 0; i < faces.size(); ++i)
        for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
          faces_at[edge_of(mesh, faces[i], v)].push_back(i);

      const unsigned int        none = faces.size();
      std::vector<unsigned int> part(faces.size(), none);
      for (unsigned int start = 0; start < faces.size(); ++start)
        {
          std::vector<unsigned int> to_visit;
          if (part[start] == none)
            to_visit.push_back(start);
          while (!to_visit.empty())
            {
              const unsigned int i = to_visit.back();
              to_visit.pop_back();
              part[i] = start;
              for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
                for (const unsigned int j :
                     faces_at[edge_of(mesh, faces[i], v)])
                  if (part[j] == none)
                    to_visit.push_back(j);
            }
        }
      return part;
    }



    /// How far a face goes from an edge of this length, in m: as far as cells
    /// of equal edges would.
    double
    extent_across(const Mesh<3>       &mesh,
                  const Mesh<3>::Face &face,
                  const double         edge)
    {
      const double height_of_triangle = std::sqrt(3.) / 2.;
      return vector_area(mesh, face).norm() / edge /
             (is_simplex(mesh.cell_type) ? height_of_triangle / 2. : 1.);
    }



    /// Smallest and largest x and z of an outlet, and where it is cut.
    struct Extent
    {
      std::array<double, 2> lower{{infinity, infinity}},
        upper{{-infinity, -infinity}};
      std::array<bool, 2> is_cut{{false, false}};

      double
      whole_length(const unsigned int direction) const
      {
        return (upper[direction] - lower[direction]) *
               (is_cut[direction] ? 2. : 1.);
      }
    };
  } // namespace



  template <>
  std::vector<MeshOutlet>
  mesh_outlets<3>(const Mesh<3> &mesh)
  {
    const auto faces = faces_with_role(mesh, BoundaryRole::outlet);
    // Lips are where floor or hopper end: at an upright wall a slot ends.
    const auto lips   = edges_of(mesh, [](const BoundaryRole role) {
      return role == BoundaryRole::floor || role == BoundaryRole::hopper ||
             role == BoundaryRole::insert;
    });
    const auto planes = edges_of(mesh, [](const BoundaryRole role) {
      return role == BoundaryRole::axis;
    });

    const auto                         part = connected_parts(mesh, faces);
    std::map<unsigned int, Extent>     extents;
    std::map<unsigned int, MeshOutlet> outlets;
    for (unsigned int i = 0; i < faces.size(); ++i)
      for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
        {
          const Edge  edge   = edge_of(mesh, faces[i], v);
          const auto &a      = mesh.vertices[edge.first],
                     &b      = mesh.vertices[edge.second];
          Extent     &extent = extents[part[i]];
          MeshOutlet &outlet = outlets[part[i]];
          for (unsigned int d = 0; d < 2; ++d)
            {
              const auto [lower, upper] = std::minmax(a[2 * d], b[2 * d]);
              extent.lower[d]           = std::min(extent.lower[d], lower);
              extent.upper[d]           = std::max(extent.upper[d], upper);
              if (planes.count(edge) > 0 &&
                  upper - lower < 1e-6 * a.distance(b))
                extent.is_cut[d] = true;
            }
          if (lips.count(edge) > 0)
            outlet.edge_at_lip =
              std::max(outlet.edge_at_lip,
                       extent_across(mesh, faces[i], a.distance(b)));
        }
    std::vector<MeshOutlet> result;
    for (auto &[number, outlet] : outlets)
      {
        outlet.width = std::min(extents[number].whole_length(0),
                                extents[number].whole_length(1));
        result.push_back(outlet);
      }
    return result;
  }
} // namespace Sandglass
