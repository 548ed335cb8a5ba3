#include <sandglass/observers/wall_lines.h>

#include <algorithm>

namespace Sandglass
{
  WallLines::WallLines(const Mesh &mesh, const Point<dim> &bottom_centre)
  {
    for (const BoundaryRole role : {BoundaryRole::wall,
                                    BoundaryRole::floor,
                                    BoundaryRole::hopper,
                                    BoundaryRole::outlet})
      add_lines(mesh, role, bottom_centre);
  }



  const WallLines::Place &
  WallLines::find(const BoundaryRole role, const Point<dim> &vertex) const
  {
    return places.at(key(role, vertex));
  }



  void
  WallLines::add_lines(const Mesh        &mesh,
                       const BoundaryRole role,
                       const Point<dim>  &bottom_centre)
  {
    Neighbors neighbors;
    for (const auto &edge : mesh.edges)
      if (edge.role == role)
        for (const unsigned int v : {0u, 1u})
          neighbors[edge.vertices[v]].push_back(edge.vertices[1 - v]);

    // Ends come before vertices in the middle of a line, then the nearest.
    const auto comes_before = [&](const auto &a, const auto &b) {
      const bool a_is_end = a.second.size() == 1;
      const bool b_is_end = b.second.size() == 1;
      if (a_is_end != b_is_end)
        return a_is_end;
      return mesh.vertices[a.first].distance_square(bottom_centre) <
             mesh.vertices[b.first].distance_square(bottom_centre);
    };
    for (unsigned int line = 0; !neighbors.empty(); ++line)
      {
        const auto start =
          std::min_element(neighbors.begin(), neighbors.end(), comes_before);
        follow_line(mesh, role, start->first, line, neighbors);
      }
  }



  void
  WallLines::follow_line(const Mesh        &mesh,
                         const BoundaryRole role,
                         unsigned int       vertex,
                         const unsigned int line,
                         Neighbors         &neighbors)
  {
    double arc_length = 0.;
    while (true)
      {
        places[key(role, mesh.vertices[vertex])] = {line, arc_length};
        const auto candidates                    = neighbors.at(vertex);
        neighbors.erase(vertex);
        const auto next =
          std::find_if(candidates.begin(),
                       candidates.end(),
                       [&neighbors](const unsigned int candidate) {
                         return neighbors.count(candidate) > 0;
                       });
        if (next == candidates.end())
          return;
        arc_length += mesh.vertices[vertex].distance(mesh.vertices[*next]);
        vertex = *next;
      }
  }
} // namespace Sandglass
