#include <deal.II/base/exceptions.h>

#include <sandglass/flow/updated_lagrangian/rezoning/triangle_mesh.h>

#include <algorithm>
#include <map>
#include <utility>

namespace Sandglass
{
  namespace
  {
    /// Number the parts of the mesh that hang together by edges.
    std::vector<unsigned int>
    number_bodies(const std::vector<std::array<unsigned int, 3>> &neighbours)
    {
      std::vector<unsigned int> bodies(neighbours.size(),
                                       numbers::invalid_unsigned_int);
      unsigned int              n_bodies = 0;
      std::vector<unsigned int> to_visit;
      for (unsigned int first = 0; first < bodies.size(); ++first)
        {
          if (bodies[first] != numbers::invalid_unsigned_int)
            continue;
          bodies[first] = n_bodies;
          to_visit      = {first};
          while (!to_visit.empty())
            {
              const unsigned int cell = to_visit.back();
              to_visit.pop_back();
              for (const unsigned int next : neighbours[cell])
                if (next != numbers::invalid_unsigned_int &&
                    bodies[next] == numbers::invalid_unsigned_int)
                  {
                    bodies[next] = n_bodies;
                    to_visit.push_back(next);
                  }
            }
          ++n_bodies;
        }
      return bodies;
    }
  } // namespace



  unsigned int
  TriangleMesh::n_bodies() const
  {
    return bodies.empty() ? 0 :
                            *std::max_element(bodies.begin(), bodies.end()) + 1;
  }



  std::array<Point<2>, 3>
  TriangleMesh::edge_points(const unsigned int cell,
                            const unsigned int edge) const
  {
    const Point<2> &start = nodes[cells[cell][edge]];
    const Point<2> &end   = nodes[cells[cell][(edge + 1) % 3]];
    if (order == 1)
      return {{start, end, start + (end - start) / 2.}};
    return {{start, end, nodes[cells[cell][3 + edge]]}};
  }



  std::vector<unsigned int>
  TriangleMesh::edge_nodes(const unsigned int cell,
                           const unsigned int edge) const
  {
    std::vector<unsigned int> result{cells[cell][edge],
                                     cells[cell][(edge + 1) % 3]};
    if (order == 2)
      result.push_back(cells[cell][3 + edge]);
    return result;
  }



  void
  add_edge_nodes(TriangleMesh &mesh)
  {
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> middle_of;
    for (auto &cell : mesh.cells)
      for (unsigned int edge = 0; edge < 3; ++edge)
        {
          const unsigned int a = cell[edge], b = cell[(edge + 1) % 3];
          const auto [known, is_new] =
            middle_of.emplace(std::minmax(a, b), mesh.nodes.size());
          cell[3 + edge] = known->second;
          if (is_new)
            mesh.nodes.push_back(mesh.nodes[a] +
                                 (mesh.nodes[b] - mesh.nodes[a]) / 2.);
        }
  }



  std::vector<unsigned int>
  bodies_of_nodes(const TriangleMesh &mesh)
  {
    std::vector<unsigned int> bodies(mesh.nodes.size(),
                                     numbers::invalid_unsigned_int);
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int i = 0; i < mesh.n_nodes_per_cell(); ++i)
        {
          unsigned int &body = bodies[mesh.cells[cell][i]];
          if (body == numbers::invalid_unsigned_int)
            body = mesh.bodies[cell];
        }
    return bodies;
  }



  std::vector<std::array<unsigned int, 3>>
  neighbours_of_cells(const TriangleMesh &mesh)
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;
    std::vector<std::array<unsigned int, 3>> neighbours(mesh.cells.size(),
                                                        {{none, none, none}});
    using Edge = std::pair<unsigned int, unsigned int>;
    std::map<Edge, Edge> open_edges;
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int edge = 0; edge < 3; ++edge)
        {
          const unsigned int start = mesh.cells[cell][edge];
          const unsigned int end   = mesh.cells[cell][(edge + 1) % 3];
          // The neighbour passes the edge the other way.
          const auto other = open_edges.find({end, start});
          if (other == open_edges.end())
            {
              const bool is_new =
                open_edges.emplace(Edge{start, end}, Edge{cell, edge}).second;
              Assert(is_new,
                     ExcMessage("Two cells lie on one side of an edge."));
              (void)is_new;
              continue;
            }
          neighbours[cell][edge] = other->second.first;
          neighbours[other->second.first][other->second.second] = cell;
          open_edges.erase(other);
        }
    return neighbours;
  }



  void
  find_boundary(TriangleMesh                                          &mesh,
                const std::function<unsigned int(const unsigned int,
                                                 const unsigned int)> &mark_of)
  {
    const auto neighbours = neighbours_of_cells(mesh);
    mesh.bodies           = number_bodies(neighbours);
    mesh.boundary.clear();
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int edge = 0; edge < 3; ++edge)
        if (neighbours[cell][edge] == numbers::invalid_unsigned_int)
          mesh.boundary.push_back({cell, edge, mark_of(cell, edge)});
  }
} // namespace Sandglass
