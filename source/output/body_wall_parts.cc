#include <sandglass/output/body_wall_parts.h>
#include <sandglass/output/small_sine.h>
#include <sandglass/scene/mesh_faces.h>
#include <sandglass/walls/face_geometry.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Sandglass
{
  namespace
  {
    /// Cosines of angles above this are one.
    constexpr double same_direction = 1. - 1e-5;
    /// A wall with more directions goes round.
    constexpr unsigned int most_sides = 6;



    /// The faces of a wall with one outward normal.
    struct Side
    {
      Tensor<1, 3>              normal;
      double                    area    = 0.;
      unsigned int              n_faces = 0;
      std::vector<unsigned int> vertices;
    };



    std::vector<Side>
    find_sides(const Scene<3> &scene, const WallId wall)
    {
      std::vector<Side> sides;
      for (const auto &face : scene.mesh.faces)
        {
          if (boundary_part(scene.walls, face.boundary_id()).wall != wall)
            continue;
          const Tensor<1, 3> area   = vector_area(scene.mesh, face);
          const Tensor<1, 3> normal = area / area.norm();
          auto               side =
            std::find_if(sides.begin(), sides.end(), [&](const Side &known) {
              return known.normal * normal > same_direction;
            });
          if (side == sides.end())
            side = sides.insert(sides.end(), {normal, 0., 0, {}});
          side->area += area.norm();
          ++side->n_faces;
          for (unsigned int v = 0; v < scene.mesh.vertices_per_face(); ++v)
            side->vertices.push_back(face.vertices[v]);
        }
      return sides;
    }



    Side
    joined(const std::vector<Side> &sides)
    {
      Side all;
      for (const Side &side : sides)
        {
          all.area += side.area;
          all.n_faces += side.n_faces;
          all.vertices.insert(all.vertices.end(),
                              side.vertices.begin(),
                              side.vertices.end());
        }
      return all;
    }



    /// In which horizontal direction a normal points, if in one.
    std::string
    name_of_direction(const Tensor<1, 3> &normal)
    {
      if (std::hypot(normal[0], normal[2]) <= small_sine)
        return "around";
      return std::abs(normal[0]) >= std::abs(normal[2]) ?
               (normal[0] > 0. ? "right" : "left") :
               (normal[2] > 0. ? "front" : "back");
    }
  } // namespace



  BodyWallParts::BodyWallParts(const Scene<3> &scene)
    : middle(SiloMeasures<3>(scene).bottom_centre)
    , has_slot(SiloMeasures<3>(scene).has_slot)
  {
    for (WallId wall = 0; wall < scene.walls.size(); ++wall)
      {
        std::vector<Side> sides    = find_sides(scene, wall);
        const bool        is_plane = sides.size() <= most_sides;
        if (!is_plane)
          sides = {joined(sides)};
        for (const Side &side : sides)
          {
            Part part{wall, "around", side.normal, false, 0., 0., 1., 1};
            if (is_plane)
              {
                part.side     = name_of_direction(side.normal);
                part.is_floor = std::abs(side.normal[1]) > 1. - small_sine;
              }
            double lower = std::numeric_limits<double>::max(), upper = -lower;
            for (const unsigned int vertex : side.vertices)
              {
                const double x = coordinate(part, scene.mesh.vertices[vertex]);
                lower          = std::min(lower, x);
                upper          = std::max(upper, x);
              }
            part.begin  = lower;
            part.length = upper - lower;
            if (is_plane && !part.is_floor)
              part.slant = 1. / std::hypot(side.normal[0], side.normal[2]);
            // Triangles are half as large as squares of the same edges.
            const double edge =
              std::sqrt(side.area / side.n_faces *
                        (is_simplex(scene.mesh.cell_type) ? 2. : 1.));
            part.n_bands =
              std::max(1., std::round(part.length * part.slant / edge));
            parts.push_back(part);
          }
      }
  }



  unsigned int
  BodyWallParts::part_of(const WallRecord &record) const
  {
    unsigned int best    = 0;
    double       closest = -2.;
    for (unsigned int i = 0; i < parts.size(); ++i)
      if (parts[i].wall == record.wall)
        if (const double cosine = parts[i].normal.norm() == 0. ?
                                    1. :
                                    parts[i].normal * record.normal;
            cosine > closest)
          {
            best    = i;
            closest = cosine;
          }
    return best;
  }



  unsigned int
  BodyWallParts::band_of(const unsigned int part,
                         const Point<3>    &position) const
  {
    const Part  &of = parts[part];
    const double share =
      (coordinate(of, position) - of.begin) /
      std::max(of.length, 1e-12 * std::abs(of.begin) + 1e-300);
    return std::lround(of.n_bands * std::clamp(share, 0., 1.));
  }



  double
  BodyWallParts::arc_length(const unsigned int part,
                            const Point<3>    &position) const
  {
    return (coordinate(parts[part], position) - parts[part].begin) *
           parts[part].slant;
  }



  double
  BodyWallParts::distance_from_middle(const Point<3> &position) const
  {
    const double x = position[0] - middle[0], z = position[2] - middle[2];
    return has_slot ? std::abs(x) : std::hypot(x, z);
  }



  Tensor<1, 3>
  BodyWallParts::tangent(const WallRecord &record) const
  {
    const Tensor<1, 3> &normal = record.normal;
    Tensor<1, 3>        along({0., 1., 0.});
    if (std::hypot(normal[0], normal[2]) <= small_sine)
      along = Tensor<1, 3>({record.position[0] - middle[0],
                            0.,
                            has_slot ? 0. : record.position[2] - middle[2]});
    along -= (along * normal) * normal;
    const double length = along.norm();
    return length > 0. ? along / length : along;
  }
} // namespace Sandglass
