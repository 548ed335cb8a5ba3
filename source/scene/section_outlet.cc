#include <sandglass/scene/mesh_faces.h>
#include <sandglass/scene/mesh_outlet.h>

#include <algorithm>
#include <map>
#include <set>

namespace Sandglass
{
  namespace
  {
    /// The vertices of faces of a kind.
    template <typename IsOfKind>
    std::set<unsigned int>
    vertices_of(const Mesh<2> &mesh, const IsOfKind &is_of_kind)
    {
      std::set<unsigned int> vertices;
      for (const auto &face : mesh.faces)
        if (is_of_kind(face.role))
          vertices.insert(face.vertices.begin(), face.vertices.end());
      return vertices;
    }



    /// For each face of the outlet a number that faces which hang together
    /// share.
    std::vector<unsigned int>
    connected_parts(const std::vector<Mesh<2>::Face> &faces)
    {
      std::vector<unsigned int> part(faces.size());
      for (unsigned int i = 0; i < faces.size(); ++i)
        part[i] = i;
      std::map<unsigned int, unsigned int> face_at;
      for (unsigned int i = 0; i < faces.size(); ++i)
        for (const unsigned int vertex : faces[i].vertices)
          {
            const auto [entry, is_new] = face_at.emplace(vertex, i);
            const unsigned int joined  = part[entry->second];
            if (!is_new)
              std::replace(part.begin(), part.end(), part[i], joined);
          }
      return part;
    }
  } // namespace



  template <>
  std::vector<MeshOutlet>
  mesh_outlets<2>(const Mesh<2> &mesh)
  {
    const auto faces    = faces_with_role(mesh, BoundaryRole::outlet);
    const auto on_walls = vertices_of(mesh, [](const BoundaryRole role) {
      return is_wall(role) && role != BoundaryRole::outlet;
    });
    const auto on_axis  = vertices_of(mesh, [](const BoundaryRole role) {
      return role == BoundaryRole::axis;
    });
    const auto touches  = [](const auto &face, const auto &vertices) {
      return vertices.count(face.vertices[0]) > 0 ||
             vertices.count(face.vertices[1]) > 0;
    };

    const auto                         part = connected_parts(faces);
    std::map<unsigned int, MeshOutlet> outlets;
    std::set<unsigned int>             halves;
    for (unsigned int i = 0; i < faces.size(); ++i)
      {
        const double length = mesh.vertices[faces[i].vertices[0]].distance(
          mesh.vertices[faces[i].vertices[1]]);
        MeshOutlet &outlet = outlets[part[i]];
        outlet.width += length;
        if (touches(faces[i], on_walls))
          outlet.edge_at_lip = std::max(outlet.edge_at_lip, length);
        if (touches(faces[i], on_axis))
          halves.insert(part[i]);
      }
    std::vector<MeshOutlet> result;
    for (auto &[number, outlet] : outlets)
      {
        outlet.width *= halves.count(number) > 0 ? 2. : 1.;
        result.push_back(outlet);
      }
    return result;
  }
} // namespace Sandglass
