#ifndef sandglass_scene_outlets_h
#define sandglass_scene_outlets_h

#include <sandglass/scene/mesh.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// An opening through which material leaves, and what lies below it.
  struct Outlet
  {
    /// Indices of the fall region's cells, each of them connected with all
    /// others without passing an outlet.
    std::vector<unsigned int> cells;
    /// Indices in Mesh::faces of the opening's own faces.
    std::vector<unsigned int> faces;
  };

  /**
   * The outlets of a mesh, from left to right (by x, then z, of the fall
   * regions' middles). Openings above one fall region are one outlet, since
   * what has come through them can't be told apart.
   */
  template <int dim>
  std::vector<Outlet>
  find_outlets(const Mesh<dim> &mesh);

  /// `outlet` where there is one, else `outlet_1`, `outlet_2`, ….
  std::string
  name_of_outlet(const unsigned int index, const unsigned int n_outlets);
} // namespace Sandglass

#endif
