#include "rectangle_mesh.h"

using namespace Sandglass;

Mesh<2>
Rectangle::mesh() const
{
  Mesh<2> result;
  result.cell_type = cell_type;
  for (unsigned int j = 0; j <= n_y; ++j)
    for (unsigned int i = 0; i <= n_x; ++i)
      {
        const Point regular(lower[0] + (upper[0] - lower[0]) * i / n_x,
                            lower[1] + (upper[1] - lower[1]) * j / n_y);
        const bool  is_inner = i > 0 && i < n_x && j > 0 && j < n_y;
        result.vertices.push_back(is_inner ? displaced(regular) : regular);
      }

  for (unsigned int j = 0; j < n_y; ++j)
    for (unsigned int i = 0; i < n_x; ++i)
      {
        const unsigned int a = vertex(i, j), b = vertex(i + 1, j),
                           c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
        if (cell_type == CellType::quadrilateral)
          add_cell(result, {{a, b, c, d}}, 4);
        else if (has_parallel_diagonals || (i + j) % 2 == 0)
          {
            add_cell(result, {{a, b, c, 0}}, 3);
            add_cell(result, {{a, c, d, 0}}, 3);
          }
        else
          {
            add_cell(result, {{a, b, d, 0}}, 3);
            add_cell(result, {{b, c, d, 0}}, 3);
          }
      }

  for (unsigned int i = 0; i < n_x; ++i)
    {
      result.faces.push_back({{{vertex(i, 0), vertex(i + 1, 0)}}, bottom});
      result.faces.push_back({{{vertex(i, n_y), vertex(i + 1, n_y)}}, top});
    }
  for (unsigned int j = 0; j < n_y; ++j)
    {
      result.faces.push_back({{{vertex(0, j), vertex(0, j + 1)}}, left});
      result.faces.push_back({{{vertex(n_x, j), vertex(n_x, j + 1)}}, right});
    }
  return result;
}



unsigned int
Rectangle::vertex(const unsigned int i, const unsigned int j) const
{
  return j * (n_x + 1) + i;
}



void
Rectangle::add_cell(Mesh<2>                           &mesh,
                    const std::array<unsigned int, 4> &vertices,
                    const unsigned int                 n) const
{
  Point center;
  for (unsigned int v = 0; v < n; ++v)
    center += mesh.vertices[vertices[v]] / static_cast<double>(n);
  mesh.cells.push_back({vertices, is_filled(center)});
}
