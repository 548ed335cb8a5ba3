#include <sandglass/flow/updated_lagrangian/motion/mesh_walls.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Sandglass
{
  namespace
  {
    Point<2>
    foot_on(const RigidWall &wall, const Point<2> &p)
    {
      return p - wall.gap(p) * wall.normal;
    }



    /// Whether a point of the boundary stands in a wall, where a curved edge
    /// has come out of a division. Under a free end there may be material.
    bool
    stands_in(const RigidWall     &wall,
              const Point<2>      &p,
              const MotionSetting &setting)
    {
      constexpr double slope = 0.2, deepest = 0.15;
      const double     gap     = wall.gap(p);
      const double     along   = wall.tangent * (p - wall.start);
      double           largest = deepest * setting.element_size;
      for (unsigned int e = 0; e < 2; ++e)
        if (!wall.is_axis() && wall.is_free_end[e])
          largest =
            std::min(largest, slope * (e == 0 ? along : wall.length() - along));
      return gap > 0. && (wall.is_axis() || gap < largest) && wall.reaches(p);
    }
  } // namespace



  unsigned int
  wall_of(const QuadraticCurve &curve, const MotionSetting &setting)
  {
    for (unsigned int w = 0; w < setting.walls.size(); ++w)
      {
        const RigidWall &wall      = setting.walls[w];
        double           tolerance = distance_on_wall * setting.element_size;
        for (unsigned int e = 0; e < 2; ++e)
          if (!wall.is_axis() && wall.is_free_end[e])
            for (const Point<2> &p : {curve[0], curve[1]})
              if (p.distance(e == 0 ? wall.start : wall.end) <
                  distance_at_wall_end * setting.element_size)
                tolerance = distance_at_wall_end * setting.element_size;
        const double l = wall.length();
        if (std::all_of(curve.begin(),
                        curve.end(),
                        [&](const Point<2> &p) {
                          const double along = wall.tangent * (p - wall.start);
                          return std::abs(wall.gap(p)) < tolerance &&
                                 (wall.is_axis() || (along > -tolerance &&
                                                     along < l + tolerance));
                        }) &&
            // Along the wall, with the material on its left.
            (curve[1] - curve[0]) * wall.tangent >
              0.7 * curve[1].distance(curve[0]))
          return w;
      }
    return TriangleMesh::free_surface;
  }



  void
  mark_walls(TriangleMesh &mesh, const MotionSetting &setting)
  {
    for (auto &edge : mesh.boundary)
      edge.mark = wall_of(mesh.edge_points(edge.cell, edge.edge), setting);
  }



  void
  snap_to_walls(TriangleMesh &mesh, const MotionSetting &setting)
  {
    // Of the nodes at the boundary; none of those at the free surface.
    std::map<unsigned int, std::vector<unsigned int>> walls_of;
    for (const auto &[cell, edge, mark] : mesh.boundary)
      for (const unsigned int n : mesh.edge_nodes(cell, edge))
        {
          auto &walls = walls_of[n];
          if (mark != TriangleMesh::free_surface &&
              std::find(walls.begin(), walls.end(), mark) == walls.end())
            walls.push_back(mark);
        }
    const auto moved = [&](const unsigned int n) {
      Point<2>   p     = mesh.nodes[n];
      const auto found = walls_of.find(n);
      if (found == walls_of.end())
        return p;
      if (found->second.empty())
        {
          for (const RigidWall &wall : setting.walls)
            if (stands_in(wall, p, setting))
              p = foot_on(wall, p);
          return p;
        }
      // Alternating projections end where two lines cross.
      for (unsigned int i = 0; i < (found->second.size() > 1 ? 200 : 1); ++i)
        for (const unsigned int w : found->second)
          p = foot_on(setting.walls[w], p);
      for (const unsigned int w : found->second)
        for (unsigned int e = 0; e < 2; ++e)
          {
            const RigidWall &wall = setting.walls[w];
            const Point<2>  &end  = e == 0 ? wall.start : wall.end;
            if (!wall.is_axis() && wall.is_free_end[e] &&
                p.distance(end) < distance_at_wall_end * setting.element_size)
              p = end;
          }
      return p;
    };
    std::vector<Point<2>> positions = mesh.nodes;
    for (auto &cell : mesh.cells)
      for (unsigned int i = 0; i < 3; ++i)
        positions[cell[i]] = moved(cell[i]);
    if (mesh.order == 2)
      for (auto &cell : mesh.cells)
        for (unsigned int i = 0; i < 3; ++i)
          {
            const unsigned int n = cell[3 + i];
            const unsigned int a = cell[i], b = cell[(i + 1) % 3];
            const auto         found = walls_of.find(n);
            if (found == walls_of.end())
              positions[n] = mesh.nodes[n] + ((positions[a] - mesh.nodes[a]) +
                                              (positions[b] - mesh.nodes[b])) /
                                               2.;
            else if (found->second.empty())
              positions[n] = moved(n);
            else
              positions[n] = positions[a] + (positions[b] - positions[a]) / 2.;
          }
    mesh.nodes = positions;
  }
} // namespace Sandglass
