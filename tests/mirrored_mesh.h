#ifndef sandglass_tests_mirrored_mesh_h
#define sandglass_tests_mirrored_mesh_h

#include <sandglass/scene/mesh.h>

#include <algorithm>
#include <cmath>

/// The whole section that a half section with the axis x = 0 stands for: its
/// cells and edges, and their mirror images.
inline Sandglass::Mesh<2>
mirrored(const Sandglass::Mesh<2> &half)
{
  using namespace Sandglass;
  Mesh<2> whole = half;

  std::vector<unsigned int> image;
  for (dealii::Point<2> vertex : half.vertices)
    if (std::abs(vertex[0]) < 1e-12)
      image.push_back(image.size());
    else
      {
        image.push_back(whole.vertices.size());
        vertex[0] = -vertex[0];
        whole.vertices.push_back(vertex);
      }

  const unsigned int n = half.vertices_per_cell();
  for (Mesh<2>::Cell cell : half.cells)
    {
      for (unsigned int v = 0; v < n; ++v)
        cell.vertices[v] = image[cell.vertices[v]];
      // counterclockwise again
      std::reverse(cell.vertices.begin(), cell.vertices.begin() + n);
      whole.cells.push_back(cell);
    }

  whole.faces.clear();
  for (const Mesh<2>::Face &edge : half.faces)
    if (edge.role != BoundaryRole::axis)
      {
        whole.faces.push_back(edge);
        whole.faces.push_back(
          {{{image[edge.vertices[0]], image[edge.vertices[1]]}}, edge.role});
      }
  sort_along_curve(whole);
  return whole;
}

#endif
