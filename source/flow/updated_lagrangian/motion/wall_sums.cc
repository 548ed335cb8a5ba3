#include <sandglass/choices/choose_kinematics.h>
#include <sandglass/flow/in_space.h>
#include <sandglass/flow/updated_lagrangian/motion/rigid_walls.h>
#include <sandglass/flow/updated_lagrangian/motion/wall_sums.h>
#include <sandglass/scene/mesh_faces.h>

#include <algorithm>
#include <array>

namespace Sandglass
{
  WallSums::WallSums(const Scene<2> &scene)
  {
    const Mesh<2> &mesh     = scene.mesh;
    const auto     cells_at = cells_at_faces(mesh);
    for (const auto &face : mesh.faces)
      {
        const WallId wall = boundary_part(scene.walls, face.boundary_id()).wall;
        const auto   cells =
          cells_at.find(key_of<2>(face.vertices, mesh.vertices_per_face()));
        if (wall == no_wall || cells == cells_at.end() ||
            cells->second.size() != 1)
          continue;
        Edge         edge{wall,
                  {{mesh.vertices[face.vertices[0]],
                            mesh.vertices[face.vertices[1]]}},
                  {}};
        Tensor<1, 2> along = edge.ends[1] - edge.ends[0];
        Tensor<1, 2> normal({along[1], -along[0]});
        normal /= normal.norm();
        const auto  &cell = mesh.cells[cells->second[0]];
        Tensor<1, 2> inside;
        for (unsigned int v = 0; v < 3; ++v)
          inside += mesh.vertices[cell.vertices[v]] - edge.ends[0];
        if (inside * normal > 0.)
          normal *= -1.;
        for (unsigned int v = 0; v < 2; ++v)
          {
            // The linear shape function's integral, as in Support.
            const Point<2> &p = edge.ends[v], &other = edge.ends[1 - v];
            const double    area =
              along.norm() / 2. *
              measure<2>(scene.formulation,
                         Point<2>((2. * Tensor<1, 2>(p) + other) / 3.));
            const auto known =
              std::find_if(sums.begin(), sums.end(), [&](const auto &record) {
                return record.wall == wall &&
                       record.vertex == face.vertices[v] &&
                       record.normal * in_space(normal) > 1. - 1e-8;
              });
            edge.records[v] = known - sums.begin();
            if (known == sums.end())
              sums.push_back({wall,
                              face.vertices[v],
                              in_space(p),
                              in_space(normal),
                              area,
                              Tensor<1, 3>()});
            else
              known->area += area;
          }
        edges.push_back(edge);
      }
  }



  void
  WallSums::add(const WallId        wall,
                const Point<2>     &position,
                const Tensor<1, 2> &impulse)
  {
    const Edge *best     = nullptr;
    double      share    = 0.;
    double      distance = std::numeric_limits<double>::max();
    for (const Edge &edge : edges)
      if (edge.wall == wall)
        {
          const Tensor<1, 2> along = edge.ends[1] - edge.ends[0];
          const double       t =
            std::clamp((position - edge.ends[0]) * along / along.norm_square(),
                       0.,
                       1.);
          const double d = position.distance(edge.ends[0] + t * along);
          if (d < distance)
            {
              distance = d;
              share    = t;
              best     = &edge;
            }
        }
    if (!best)
      return;
    sums[best->records[0]].impulse += in_space((1. - share) * impulse);
    sums[best->records[1]].impulse += in_space(share * impulse);
  }



  void
  WallSums::clear()
  {
    for (WallRecord &record : sums)
      record.impulse = 0.;
  }
} // namespace Sandglass
