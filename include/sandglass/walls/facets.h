#ifndef sandglass_walls_facets_h
#define sandglass_walls_facets_h

#include <deal.II/base/tensor.h>

#include <sandglass/walls/wall.h>

#include <vector>

namespace Sandglass
{
  using namespace dealii;

  /// A face of the boundary at one of its nodes.
  template <int dim>
  struct Facet
  {
    Tensor<1, dim> normal; ///< outward from the material, unit length
    WallId         wall;   ///< no_wall: the axis
    double         area;   ///< that belongs to the node, in m^2
  };

  template <int dim>
  using Facets = std::vector<Facet<dim>>;

  /// Normals with a larger scalar product have the same direction.
  constexpr double same_direction = 1. - 1e-8;

  /**
   * Leave the faces at a node of a body no more directions than they need.
   * Those of one wall that turn gradually stand for a curved surface, and get
   * its mean direction. Where walls have more than three directions all the
   * same, as in the corner of a pyramid below a square silo, those nearest to
   * each other become one.
   */
  void
  unite_directions(Facets<3> &facets);
} // namespace Sandglass

#endif
