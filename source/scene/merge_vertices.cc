#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/merge_vertices.h>
#include <sandglass/scene/mesh_faces.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace Sandglass
{
  namespace
  {
    /// Of the mesh's extent: vertices that are closer are at the same place.
    constexpr double same_place = 1e-8;



    /// Length of the diagonal of the box around the cells, in m. Nodes that no
    /// cell has may be anywhere.
    template <int dim>
    double
    extent(const Mesh<dim> &mesh)
    {
      dealii::Point<dim> lower = mesh.vertices[mesh.cells[0].vertices[0]];
      dealii::Point<dim> upper = lower;
      for (const auto &cell : mesh.cells)
        for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double x = mesh.vertices[cell.vertices[v]][d];
              lower[d]       = std::min(lower[d], x);
              upper[d]       = std::max(upper[d], x);
            }
      return lower.distance(upper);
    }



    /// For each vertex the first one at its place.
    template <int dim>
    std::vector<unsigned int>
    first_at_place(const Mesh<dim> &mesh)
    {
      const auto &vertices = mesh.vertices;
      // Along a direction in which no mesh has its rows.
      dealii::Tensor<1, dim> direction;
      for (unsigned int d = 0; d < dim; ++d)
        direction[d] = 1. / (1. + 0.618 * d);

      std::vector<std::pair<double, unsigned int>> order;
      for (unsigned int i = 0; i < vertices.size(); ++i)
        if (std::isfinite(vertices[i].norm()))
          order.emplace_back(vertices[i] * direction, i);
      std::sort(order.begin(), order.end());

      const double              distance = same_place * extent(mesh);
      std::vector<unsigned int> first(vertices.size());
      std::iota(first.begin(), first.end(), 0u);
      for (std::size_t n = 0; n < order.size(); ++n)
        for (std::size_t m = n; m-- > 0 && order[n].first - order[m].first <=
                                             distance * direction.norm();)
          {
            const unsigned int i = order[n].second, j = order[m].second;
            if (vertices[i].distance(vertices[j]) <= distance)
              first[i] = std::min(first[i], first[j]);
          }
      return first;
    }



    /// Whether faces with these groups have material on both sides.
    bool
    lets_pass(const std::set<std::string> &groups)
    {
      return std::all_of(groups.begin(),
                         groups.end(),
                         [](const std::string &group) {
                           return group == name_of(BoundaryRole::outlet) ||
                                  group == name_of(BoundaryRole::top);
                         });
    }



    template <int dim>
    class Merger
    {
    public:
      Merger(Mesh<dim> &mesh, GmshMesh &gmsh_mesh)
        : mesh(mesh)
        , lines(gmsh_mesh.elements[dim - 1])
        , first(first_at_place(mesh))
        , root(mesh.vertices.size())
      {
        std::iota(root.begin(), root.end(), 0u);
      }

      unsigned int
      merge()
      {
        join_open_faces();
        std::set<unsigned int> replaced;
        for (auto &cell : mesh.cells)
          for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
            if (const unsigned int kept = find_root(cell.vertices[v]);
                kept != cell.vertices[v])
              {
                replaced.insert(cell.vertices[v]);
                cell.vertices[v] = kept;
              }
        put_faces_on_cells();
        return replaced.size();
      }

    private:
      using Key = FaceKey<dim>;

      unsigned int
      find_root(unsigned int vertex) const
      {
        while (root[vertex] != vertex)
          vertex = root[vertex];
        return vertex;
      }

      /// The key of a face's place.
      template <typename Vertices>
      Key
      place_of(const Vertices &vertices) const
      {
        Key place{};
        for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
          place[v] = first[vertices[v]];
        return key_of<dim>(place, mesh.vertices_per_face());
      }

      /// Join the vertices of faces that lie at the same place.
      void
      join_open_faces()
      {
        std::map<Key, std::vector<Key>> faces_at;
        for (const auto &[face, cells] : cells_at_faces(mesh))
          if (cells.size() == 1)
            faces_at[place_of(face)].push_back(face);
        std::map<Key, std::set<std::string>> groups_at;
        for (const auto &line : lines)
          groups_at[place_of(line.corners)].insert(line.groups.begin(),
                                                   line.groups.end());

        const unsigned int n = mesh.vertices_per_face();
        for (const auto &[place, faces] : faces_at)
          if (faces.size() > 1 && lets_pass(groups_at[place]))
            for (unsigned int v = 0; v < n; ++v)
              for (unsigned int w = 0; w < n; ++w)
                if (first[faces[0][v]] == first[faces[1][w]])
                  join(faces[0][v], faces[1][w]);
      }

      void
      join(const unsigned int a, const unsigned int b)
      {
        const unsigned int root_a = find_root(a), root_b = find_root(b);
        root[std::max(root_a, root_b)] = std::min(root_a, root_b);
      }

      void
      put_faces_on_cells()
      {
        const CellsAtFaces<dim>         faces = cells_at_faces(mesh);
        std::map<Key, std::vector<Key>> faces_at;
        for (const auto &[face, cells] : faces)
          faces_at[place_of(face)].push_back(face);

        std::vector<GmshMesh::Element> lines_on_cells;
        for (GmshMesh::Element &line : lines)
          {
            Key key{};
            for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
              key[v] = line.corners[v] = find_root(line.corners[v]);
            const auto there = faces_at.find(place_of(line.corners));
            if (faces.count(key_of<dim>(key, mesh.vertices_per_face())) > 0 ||
                there == faces_at.end())
              lines_on_cells.push_back(line);
            else
              for (const Key &face : there->second)
                {
                  std::copy(face.begin(),
                            face.begin() + line.corners.size(),
                            line.corners.begin());
                  lines_on_cells.push_back(line);
                }
          }
        lines = std::move(lines_on_cells);
      }

      Mesh<dim>                      &mesh;
      std::vector<GmshMesh::Element> &lines;
      const std::vector<unsigned int> first;
      /// Leads from each vertex to the one that takes its place.
      std::vector<unsigned int> root;
    };
  } // namespace



  template <int dim>
  unsigned int
  merge_vertices(Mesh<dim> &mesh, GmshMesh &gmsh_mesh)
  {
    return Merger<dim>(mesh, gmsh_mesh).merge();
  }



#define INSTANTIATE(dim) \
  template unsigned int merge_vertices<dim>(Mesh<dim> &, GmshMesh &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
