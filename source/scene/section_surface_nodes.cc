#include <sandglass/scene/mesh_faces.h>
#include <sandglass/scene/section_surface_nodes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    /// Of a node on the boundary, in which direction that goes on.
    struct Boundary
    {
      Tensor<1, 2> tangent; ///< of unit length
      bool         is_corner = false;
    };

    class NodeMover
    {
    public:
      NodeMover(Mesh<2>                             &mesh,
                const std::set<unsigned int>        &surface,
                const std::function<double(double)> &height)
        : mesh(mesh)
        , surface(surface)
        , height(height)
        , cells_of(mesh.vertices.size())
      {
        for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
          for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
            cells_of[mesh.cells[cell].vertices[v]].push_back(cell);
        find_boundary();
        find_neighborhood();
      }

      void
      move()
      {
        constexpr unsigned int n_sweeps = 60;
        for (unsigned int sweep = 0; sweep < n_sweeps; ++sweep)
          {
            for (const unsigned int node : surface)
              approach(node);
            for (const unsigned int node : neighborhood)
              relax(node);
          }
      }

    private:
      /// Of a cell, between 0 (flat) and 1 (square corners).
      static constexpr double smallest_quality = 0.25;

      void
      find_boundary()
      {
        constexpr double same_direction = 1. - 1e-8;
        for (const auto &[vertices, cells] : cells_at_faces(mesh))
          if (cells.size() == 1)
            {
              Tensor<1, 2> tangent =
                mesh.vertices[vertices[1]] - mesh.vertices[vertices[0]];
              tangent /= tangent.norm();
              for (const unsigned int vertex : vertices)
                {
                  const auto [entry, is_new] =
                    boundary.emplace(vertex, Boundary{tangent});
                  if (!is_new && std::abs(entry->second.tangent * tangent) <
                                   same_direction)
                    entry->second.is_corner = true;
                }
            }
        // What has a name ends where it ends.
        std::map<unsigned int, std::set<types::boundary_id>> names;
        for (const auto &face : mesh.faces)
          for (const unsigned int vertex : face.vertices)
            if (surface.count(face.vertices[0]) == 0 ||
                surface.count(face.vertices[1]) == 0)
              names[vertex].insert(face.boundary_id());
        for (auto &[vertex, of_vertex] : boundary)
          if (names[vertex].size() > 1)
            of_vertex.is_corner = true;
      }

      /// The nodes within some cells of the surface, but not on it.
      void
      find_neighborhood()
      {
        constexpr unsigned int n_rings = 3;
        std::set<unsigned int> reached = surface;
        for (unsigned int ring = 0; ring < n_rings; ++ring)
          {
            std::set<unsigned int> next = reached;
            for (const unsigned int node : reached)
              for (const unsigned int cell : cells_of[node])
                next.insert(mesh.cells[cell].vertices.begin(),
                            mesh.cells[cell].vertices.begin() +
                              mesh.vertices_per_cell());
            reached = std::move(next);
          }
        std::set<unsigned int> inner_faces;
        for (const auto &face : mesh.faces)
          inner_faces.insert(face.vertices.begin(), face.vertices.end());
        for (const unsigned int node : reached)
          if (surface.count(node) == 0 && boundary.count(node) == 0 &&
              inner_faces.count(node) == 0)
            neighborhood.push_back(node);
      }

      double
      quality(const unsigned int cell) const
      {
        const auto        &vertices = mesh.cells[cell].vertices;
        const unsigned int n        = mesh.vertices_per_cell();
        double             worst    = std::numeric_limits<double>::max();
        for (unsigned int v = 0; v < n; ++v)
          {
            const Point<2>    &corner = mesh.vertices[vertices[v]];
            const Tensor<1, 2> a =
              mesh.vertices[vertices[(v + 1) % n]] - corner;
            const Tensor<1, 2> b =
              mesh.vertices[vertices[(v + n - 1) % n]] - corner;
            worst = std::min(worst,
                             2. * (a[0] * b[1] - a[1] * b[0]) /
                               (a.norm_square() + b.norm_square()));
          }
        return worst;
      }

      /// Of the worst cell at a node.
      double
      quality_at(const unsigned int node) const
      {
        double worst = std::numeric_limits<double>::max();
        for (const unsigned int cell : cells_of[node])
          worst = std::min(worst, quality(cell));
        return worst;
      }

      /// Where a node has to go along its direction to be on the line.
      Point<2>
      goal(const unsigned int node) const
      {
        constexpr double smallest_slope = 0.2;

        Point<2>   place = mesh.vertices[node];
        const auto entry = boundary.find(node);
        const bool is_fixed =
          entry != boundary.end() &&
          (entry->second.is_corner ||
           std::abs(entry->second.tangent[1]) < smallest_slope);
        if (is_fixed)
          return place;
        const Tensor<1, 2> direction = entry == boundary.end() ?
                                         Tensor<1, 2>({0., 1.}) :
                                         entry->second.tangent;
        // The line is straight but for its apex.
        for (unsigned int i = 0; i < 20; ++i)
          place += (height(place[0]) - place[1]) / direction[1] * direction;
        return std::abs(height(place[0]) - place[1]) <
                   1e-6 * mesh.vertices[node].distance(place) + 1e-12 ?
                 place :
                 mesh.vertices[node];
      }

      void
      approach(const unsigned int node)
      {
        const Point<2> before   = mesh.vertices[node];
        const double   at_first = quality_at(node);
        const Point<2> end      = goal(node);
        for (const double share : {1., 0.5, 0.25})
          {
            mesh.vertices[node] = before + share * (end - before);
            if (share == 1.)
              mesh.vertices[node] = end;
            if (quality_at(node) >= std::min(smallest_quality, at_first))
              return;
          }
        mesh.vertices[node] = before;
      }

      /// Move a node towards the middle of its neighbours if that helps.
      void
      relax(const unsigned int node)
      {
        const Point<2> before   = mesh.vertices[node];
        const double   at_first = quality_at(node);
        Tensor<1, 2>   sum;
        unsigned int   n_neighbors = 0;
        for (const unsigned int cell : cells_of[node])
          for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
            if (const unsigned int other = mesh.cells[cell].vertices[v];
                other != node)
              {
                sum += mesh.vertices[other];
                ++n_neighbors;
              }
        mesh.vertices[node] = Point<2>(sum / n_neighbors);
        if (quality_at(node) <= at_first)
          mesh.vertices[node] = before;
      }

      Mesh<2>                               &mesh;
      const std::set<unsigned int>          &surface;
      const std::function<double(double)>   &height;
      std::vector<std::vector<unsigned int>> cells_of; ///< of each node
      std::map<unsigned int, Boundary>       boundary; ///< nodes on it
      std::vector<unsigned int>              neighborhood;
    };
  } // namespace



  void
  move_surface_nodes(Mesh<2>                             &mesh,
                     const std::set<unsigned int>        &nodes,
                     const std::function<double(double)> &height)
  {
    NodeMover(mesh, nodes, height).move();
  }
} // namespace Sandglass
