#include <sandglass/output/section_wall_lines.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    constexpr double same_length = 1e-9;

    WallLines::Side
    side_of(const Mesh<2>                   &mesh,
            const std::vector<unsigned int> &vertices,
            const double                     middle)
    {
      double left_extent = 0., right_extent = 0.;
      for (const unsigned int vertex : vertices)
        {
          const double x = mesh.vertices[vertex][0];
          left_extent    = std::max(left_extent, middle - x);
          right_extent   = std::max(right_extent, x - middle);
        }
      return left_extent <= same_length * right_extent ?
               WallLines::Side::right :
             right_extent <= same_length * left_extent ?
               WallLines::Side::left :
               WallLines::Side::middle;
    }
  } // namespace



  WallLines::WallLines(const Mesh<2>              &mesh,
                       const std::vector<Wall<2>> &walls,
                       const Point<2>             &bottom_centre)
  {
    std::vector<Neighbors> neighbors(walls.size());
    for (const auto &edge : mesh.faces)
      {
        const WallId wall = boundary_part(walls, edge.boundary_id()).wall;
        if (wall != no_wall)
          for (const unsigned int v : {0u, 1u})
            neighbors[wall][edge.vertices[v]].push_back(edge.vertices[1 - v]);
      }
    for (WallId wall = 0; wall < walls.size(); ++wall)
      add_lines(mesh, wall, neighbors[wall], bottom_centre);
  }



  const WallLines::Place &
  WallLines::find(const WallId wall, const unsigned int vertex) const
  {
    return places.at({wall, vertex});
  }



  void
  WallLines::add_lines(const Mesh<2>  &mesh,
                       const WallId    wall,
                       Neighbors      &neighbors,
                       const Point<2> &bottom_centre)
  {
    // Ends come before vertices in the middle of a line, then the nearest.
    const auto comes_before = [&](const auto &a, const auto &b) {
      const bool a_is_end = a.second.size() == 1;
      const bool b_is_end = b.second.size() == 1;
      if (a_is_end != b_is_end)
        return a_is_end;
      const Point<2> &point_a    = mesh.vertices[a.first];
      const Point<2> &point_b    = mesh.vertices[b.first];
      const double    distance_a = point_a.distance(bottom_centre);
      const double    distance_b = point_b.distance(bottom_centre);
      // Mirror images are equally near up to rounding.
      if (std::abs(distance_a - distance_b) <= same_length * distance_a)
        return point_a[0] < point_b[0];
      return distance_a < distance_b;
    };
    for (unsigned int line = 0; !neighbors.empty(); ++line)
      {
        const auto start =
          std::min_element(neighbors.begin(), neighbors.end(), comes_before);
        const auto vertices = follow_line(start->first, neighbors);
        const Side side     = side_of(mesh, vertices, bottom_centre[0]);

        double arc_length = 0.;
        for (unsigned int i = 0; i < vertices.size(); ++i)
          {
            if (i > 0)
              arc_length += mesh.vertices[vertices[i]].distance(
                mesh.vertices[vertices[i - 1]]);
            places[{wall, vertices[i]}] = {line, arc_length, side};
          }
      }
  }



  std::vector<unsigned int>
  WallLines::follow_line(unsigned int vertex, Neighbors &neighbors)
  {
    std::vector<unsigned int> vertices;
    while (true)
      {
        vertices.push_back(vertex);
        const auto candidates = neighbors.at(vertex);
        neighbors.erase(vertex);
        const auto next =
          std::find_if(candidates.begin(),
                       candidates.end(),
                       [&neighbors](const unsigned int candidate) {
                         return neighbors.count(candidate) > 0;
                       });
        if (next == candidates.end())
          return vertices;
        vertex = *next;
      }
  }



  std::string_view
  name_of(const WallLines::Side side)
  {
    return side == WallLines::Side::left  ? "left" :
           side == WallLines::Side::right ? "right" :
                                            "middle";
  }
} // namespace Sandglass
