#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/hanging_vertex.h>
#include <sandglass/scene/mesh_cells.h>

#include <algorithm>
#include <set>

namespace Sandglass
{
  template <int dim>
  std::string
  hanging_vertex(const Mesh<dim> &mesh, std::vector<FaceKey<dim>> &faces)
  {
    if (dim != 2)
      return "";
    std::set<unsigned int> vertices;
    for (const FaceKey<dim> &face : faces)
      vertices.insert(face.begin(), face.begin() + mesh.vertices_per_face());
    for (FaceKey<dim> &face : faces)
      for (const unsigned int vertex : vertices)
        {
          const auto      &x        = mesh.vertices[vertex];
          const auto      &a        = mesh.vertices[face[0]];
          const auto       along    = mesh.vertices[face[1]] - a;
          const double     share    = (x - a) * along / along.norm_square();
          const double     farness  = (x - a - share * along).norm();
          constexpr double rounding = 1e-6;
          if (share > rounding && share < 1. - rounding &&
              farness < rounding * along.norm())
            {
              std::swap(face, faces.front());
              return ", where the vertex at " + place(x) +
                     " hangs on the edge of another cell";
            }
        }
    return "";
  }



#define INSTANTIATE(dim)                                      \
  template std::string hanging_vertex<dim>(const Mesh<dim> &, \
                                           std::vector<FaceKey<dim>> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
