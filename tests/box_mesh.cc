#include "box_mesh.h"

#include <algorithm>

using namespace Sandglass;

Mesh<3>
Box::mesh() const
{
  Mesh<3> result;
  result.cell_type = cell_type;
  for (unsigned int k = 0; k <= n[2]; ++k)
    for (unsigned int j = 0; j <= n[1]; ++j)
      for (unsigned int i = 0; i <= n[0]; ++i)
        {
          const std::array<unsigned int, 3> at{{i, j, k}};
          Point                             regular;
          bool                              is_inner = true;
          for (unsigned int d = 0; d < 3; ++d)
            {
              regular[d] = lower[d] + (upper[d] - lower[d]) * at[d] / n[d];
              is_inner   = is_inner && at[d] > 0 && at[d] < n[d];
            }
          result.vertices.push_back(
            is_inner || displaces_boundary ? displaced(regular) : regular);
        }
  for (unsigned int k = 0; k < n[2]; ++k)
    for (unsigned int j = 0; j < n[1]; ++j)
      for (unsigned int i = 0; i < n[0]; ++i)
        if (exists({{i, j, k}}))
          {
            add_cube(result, {{i, j, k}});
            for (unsigned int d = 0; d < 3; ++d)
              for (unsigned int side = 0; side < 2; ++side)
                add_side_of_cube(result, {{i, j, k}}, d, side);
          }
  leave_out_unused_vertices(result);
  return result;
}



unsigned int
Box::vertex(const Place &at) const
{
  return (at[2] * (n[1] + 1) + at[1]) * (n[0] + 1) + at[0];
}



bool
Box::is_simplex() const
{
  return cell_type == CellType::tetrahedron;
}



void
Box::add_cell(Mesh<3> &mesh, const std::array<unsigned int, 8> &vertices) const
{
  Point              center;
  const unsigned int n_vertices = mesh.vertices_per_cell();
  for (unsigned int v = 0; v < n_vertices; ++v)
    center += mesh.vertices[vertices[v]] / static_cast<double>(n_vertices);
  mesh.cells.push_back({vertices, is_filled(center)});
}



void
Box::add_cube(Mesh<3> &mesh, const Place &at) const
{
  const auto corner = [&](unsigned int i, unsigned int j, unsigned int k) {
    return vertex({{at[0] + i, at[1] + j, at[2] + k}});
  };
  if (!is_simplex())
    {
      add_cell(mesh,
               {{corner(0, 0, 0),
                 corner(1, 0, 0),
                 corner(1, 1, 0),
                 corner(0, 1, 0),
                 corner(0, 0, 1),
                 corner(1, 0, 1),
                 corner(1, 1, 1),
                 corner(0, 1, 1)}});
      return;
    }
  // One for each path along edges from the lowest to the highest corner.
  std::array<unsigned int, 3> path{{0, 1, 2}};
  do
    {
      std::array<unsigned int, 8> vertices{};
      Place                       place = at;
      vertices[0]                       = vertex(place);
      for (unsigned int step = 0; step < 3; ++step)
        {
          ++place[path[step]];
          vertices[step + 1] = vertex(place);
        }
      const bool is_even = (path[1] + 3 - path[0]) % 3 == 1;
      if (!is_even)
        std::swap(vertices[1], vertices[2]);
      add_cell(mesh, vertices);
    }
  while (std::next_permutation(path.begin(), path.end()));
}



Box::Point
Box::middle_of(const Place &at) const
{
  Point middle;
  for (unsigned int d = 0; d < 3; ++d)
    middle[d] = lower[d] + (upper[d] - lower[d]) * (at[d] + 0.5) / n[d];
  return middle;
}



bool
Box::exists(const Place &at) const
{
  return !is_left_out(middle_of(at));
}



void
Box::add_side_of_cube(Mesh<3>           &mesh,
                      const Place       &cube,
                      const unsigned int d,
                      const unsigned int side) const
{
  const bool is_of_box = cube[d] == (side == 0 ? 0 : n[d] - 1);
  Place      beside    = cube;
  beside[d] += side == 0 ? -1 : 1;
  if (!is_of_box && exists(beside))
    return;
  Point middle = middle_of(cube);
  middle[d] += (side == 0 ? -0.5 : 0.5) * (upper[d] - lower[d]) / n[d];
  const Role role = is_of_box ? roles[d][side] : role_at_gap(middle);

  const unsigned int a = (d + 1) % 3, b = (d + 2) % 3;
  const auto         corner = [&](const unsigned int i, const unsigned int j) {
    Place place = cube;
    place[d] += side;
    place[a] += i;
    place[b] += j;
    return vertex(place);
  };
  if (is_simplex())
    {
      mesh.faces.push_back(
        {{{corner(0, 0), corner(1, 0), corner(1, 1), 0}}, role});
      mesh.faces.push_back(
        {{{corner(0, 0), corner(1, 1), corner(0, 1), 0}}, role});
    }
  else
    mesh.faces.push_back(
      {{{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}}, role});
}



void
Box::leave_out_unused_vertices(Mesh<3> &mesh)
{
  constexpr unsigned int    unused = -1;
  std::vector<unsigned int> number(mesh.vertices.size(), unused);
  std::vector<Point>        vertices;
  const auto                renumber = [&](unsigned int &v) {
    if (number[v] == unused)
      {
        number[v] = vertices.size();
        vertices.push_back(mesh.vertices[v]);
      }
    v = number[v];
  };
  for (auto &cell : mesh.cells)
    for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
      renumber(cell.vertices[v]);
  for (auto &face : mesh.faces)
    for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
      renumber(face.vertices[v]);
  mesh.vertices = vertices;
}
