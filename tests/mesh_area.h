#ifndef sandglass_tests_mesh_area_h
#define sandglass_tests_mesh_area_h

#include <sandglass/scene/mesh.h>

/// Area in m^2 of the cells that material fills at the start, or of the others;
/// cells that turn clockwise count as negative.
inline double
area(const Sandglass::Mesh<2> &mesh, const bool is_filled)
{
  const unsigned int n      = mesh.vertices_per_cell();
  double             result = 0.;
  for (const auto &cell : mesh.cells)
    if (cell.is_filled == is_filled)
      for (unsigned int v = 0; v < n; ++v)
        {
          const auto &a = mesh.vertices[cell.vertices[v]];
          const auto &b = mesh.vertices[cell.vertices[(v + 1) % n]];
          result += (a[0] * b[1] - a[1] * b[0]) / 2.;
        }
  return result;
}

#endif
