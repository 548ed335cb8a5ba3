#include <sandglass/output/section_wall_corners.h>
#include <sandglass/walls/face_geometry.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace Sandglass
{
  namespace
  {
    /// Cosine of an angle that rounded coordinates may have.
    constexpr double same_direction = 1. - 1e-6;

    using AxisAtVertices = std::map<unsigned int, Tensor<1, 2>>;

    /// The direction of the axis at the vertices that lie on it.
    AxisAtVertices
    find_axis(const Mesh<2> &mesh)
    {
      AxisAtVertices axis_at;
      for (const auto &edge : mesh.faces)
        if (edge.role == BoundaryRole::axis)
          for (const unsigned int vertex : edge.vertices)
            {
              const Tensor<1, 2> along = mesh.vertices[edge.vertices[1]] -
                                         mesh.vertices[edge.vertices[0]];
              axis_at[vertex] = along / along.norm();
            }
      return axis_at;
    }



    /// Which records the edges of their walls connect.
    using Links = std::vector<std::vector<unsigned int>>;

    /// @param[in,out] normals  of the records; those of the edges replace them.
    Links
    link_records(const Mesh<2>                 &mesh,
                 const std::vector<Wall<2>>    &walls,
                 const std::vector<WallRecord> &records,
                 const AxisAtVertices          &axis_at,
                 std::vector<Tensor<1, 2>>     &normals)
    {
      std::multimap<std::pair<WallId, unsigned int>, unsigned int> records_at;
      for (unsigned int i = 0; i < records.size(); ++i)
        records_at.insert({{records[i].wall, records[i].vertex}, i});
      // None where the edge holds no material, as below the outlet.
      const auto find_record =
        [&](const WallId        wall,
            const unsigned int  vertex,
            const Tensor<1, 2> &normal) -> std::optional<unsigned int> {
        const auto [begin, end] = records_at.equal_range({wall, vertex});
        for (auto entry = begin; entry != end; ++entry)
          if (std::abs(normals[entry->second] * normal) > same_direction ||
              axis_at.count(vertex) > 0)
            return entry->second;
        return {};
      };

      Links links(records.size());
      for (const auto &edge : mesh.faces)
        {
          const WallId wall = boundary_part(walls, edge.boundary_id()).wall;
          if (wall == no_wall)
            continue;
          const Tensor<1, 2> normal =
            unit_normal<2>({{mesh.vertices[edge.vertices[0]],
                             mesh.vertices[edge.vertices[1]]}});
          const auto a = find_record(wall, edge.vertices[0], normal);
          const auto b = find_record(wall, edge.vertices[1], normal);
          if (!a || !b)
            continue;
          links[*a].push_back(*b);
          links[*b].push_back(*a);
          for (const unsigned int i : {*a, *b})
            normals[i] = std::copysign(1., normal * normals[i]) * normal;
        }
      return links;
    }



    /// From a record on, until its wall ends or meets another.
    template <typename IsCorner>
    WallCorners::Run
    follow_wall(const unsigned int             start,
                const std::vector<WallRecord> &records,
                const Links                   &links,
                const IsCorner                &is_corner)
    {
      WallCorners::Run run{{start}};
      while (!run.ends_in_corner)
        {
          const auto &next   = links[run.records.back()];
          const auto  is_new = [&run](const unsigned int record) {
            return std::count(run.records.begin(), run.records.end(), record) ==
                   0;
          };
          const auto found = std::find_if(next.begin(), next.end(), is_new);
          if (found == next.end())
            break;
          run.records.push_back(*found);
          run.ends_in_corner = is_corner(records[*found].vertex);
        }
      return run;
    }
  } // namespace



  WallCorners::WallCorners(const Mesh<2>                 &mesh,
                           const std::vector<Wall<2>>    &walls,
                           const std::vector<WallRecord> &records)
  {
    std::map<unsigned int, std::vector<unsigned int>> records_at;
    for (unsigned int i = 0; i < records.size(); ++i)
      {
        normals.push_back(
          Tensor<1, 2>({records[i].normal[0], records[i].normal[1]}));
        records_at[records[i].vertex].push_back(i);
      }
    const AxisAtVertices axis_at = find_axis(mesh);
    const Links links = link_records(mesh, walls, records, axis_at, normals);

    // The axis pulls across itself only: what a wall at right angles to it has
    // at the node between them is all the wall's own.
    const auto axis_shares = [&](const unsigned int vertex) {
      const auto axis = axis_at.find(vertex);
      return axis != axis_at.end() &&
             std::abs(normals[records_at.at(vertex)[0]] * axis->second) <
               same_direction;
    };
    const auto is_corner = [&](const unsigned int vertex) {
      return records_at.at(vertex).size() > 1 || axis_shares(vertex);
    };
    for (const auto &[vertex, of_corner] : records_at)
      if (is_corner(vertex))
        {
          Corner corner;
          if (axis_shares(vertex))
            corner.axis = axis_at.at(vertex);
          for (const unsigned int record : of_corner)
            corner.runs.push_back(
              follow_wall(record, records, links, is_corner));
          corners.push_back(corner);
        }
  }
} // namespace Sandglass
