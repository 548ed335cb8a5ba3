#include <sandglass/flow/updated_lagrangian/motion/rigid_walls.h>
#include <sandglass/scene/mesh_faces.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    constexpr double rounding = 1e-9;

    double
    cross_product(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }



    RigidWall
    wall_from(const WallId wall, const Point<2> &start, const Point<2> &end)
    {
      RigidWall result;
      result.wall    = wall;
      result.start   = start;
      result.end     = end;
      result.tangent = (end - start) / start.distance(end);
      result.normal  = Tensor<1, 2>({result.tangent[1], -result.tangent[0]});
      return result;
    }



    /// Join walls of one direction that follow each other, until none do.
    void
    join(std::vector<RigidWall> &walls)
    {
      const auto follows = [](const RigidWall &a, const RigidWall &b) {
        return a.wall == b.wall && a.end.distance(b.start) < rounding &&
               a.tangent * b.tangent > 1. - rounding;
      };
      for (bool is_changed = true; is_changed;)
        {
          is_changed = false;
          for (std::size_t a = 0; a < walls.size() && !is_changed; ++a)
            for (std::size_t b = 0; b < walls.size() && !is_changed; ++b)
              if (a != b && follows(walls[a], walls[b]))
                {
                  walls[a] =
                    wall_from(walls[a].wall, walls[a].start, walls[b].end);
                  walls.erase(walls.begin() + b);
                  is_changed = true;
                }
        }
    }



    /// An end is not free where the next wall turns towards the material.
    void
    find_free_ends(std::vector<RigidWall> &walls)
    {
      for (RigidWall &wall : walls)
        for (const RigidWall &other : walls)
          {
            if (other.start.distance(wall.end) < rounding)
              wall.is_free_end[1] =
                cross_product(wall.tangent, other.tangent) <= 0.;
            if (other.end.distance(wall.start) < rounding)
              wall.is_free_end[0] =
                cross_product(other.tangent, wall.tangent) <= 0.;
          }
    }
  } // namespace



  bool
  RigidWall::reaches(const Point<2> &p) const
  {
    if (is_axis())
      return true;
    const double along = tangent * (p - start), l = length();
    return (along >= (is_free_end[0] ? 0. : -l)) &&
           (along <= (is_free_end[1] ? l : 2. * l));
  }



  std::vector<RigidWall>
  find_rigid_walls(const Scene<2> &scene)
  {
    const Mesh<2>         &mesh     = scene.mesh;
    const auto             cells_at = cells_at_faces(mesh);
    std::vector<RigidWall> walls;
    for (const auto &face : mesh.faces)
      {
        const BoundaryPart part =
          boundary_part(scene.walls, face.boundary_id());
        const auto cells =
          cells_at.find(key_of<2>(face.vertices, mesh.vertices_per_face()));
        const bool is_axis = face.role == BoundaryRole::axis;
        if ((!is_axis && part.wall == no_wall) || cells == cells_at.end() ||
            cells->second.size() != 1)
          continue;
        Point<2> a = mesh.vertices[face.vertices[0]],
                 b = mesh.vertices[face.vertices[1]];
        Tensor<1, 2> inside;
        const auto  &cell = mesh.cells[cells->second[0]];
        for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
          inside +=
            (mesh.vertices[cell.vertices[v]] - a) / mesh.vertices_per_cell();
        if (cross_product(b - a, inside) < 0.)
          std::swap(a, b);
        walls.push_back(wall_from(is_axis ? no_wall : part.wall, a, b));
        if (!is_axis)
          walls.back().friction_coefficient =
            scene.walls[part.wall].friction_coefficient;
      }
    join(walls);
    for (RigidWall &wall : walls)
      if (!wall.is_axis())
        wall.friction_coefficient = scene.walls[wall.wall].friction_coefficient;
    find_free_ends(walls);
    return walls;
  }



  std::vector<Point<2>>
  wall_ends(const std::vector<RigidWall> &walls)
  {
    std::vector<Point<2>> ends;
    for (const RigidWall &wall : walls)
      if (!wall.is_axis())
        for (const Point<2> &end : {wall.start, wall.end})
          if (std::none_of(ends.begin(), ends.end(), [&](const Point<2> &e) {
                return e.distance(end) < rounding;
              }))
            ends.push_back(end);
    return ends;
  }



  std::vector<Point<2>>
  rigid_corners(const Scene<2> &scene, const std::vector<RigidWall> &walls)
  {
    std::vector<Point<2>> corners;
    for (const RigidWall &wall : walls)
      for (unsigned int e = 0; e < 2; ++e)
        {
          const Point<2> &end = e == 0 ? wall.start : wall.end;
          if (!wall.is_axis() && wall.is_free_end[e] &&
              end[1] < scene.fill_top - rounding)
            corners.push_back(end);
        }
    return corners;
  }
} // namespace Sandglass
