#ifndef sandglass_scene_fill_layers_h
#define sandglass_scene_fill_layers_h

#include <sandglass/scene/mesh.h>

namespace Sandglass
{
  /**
   * In which of some layers of equal height a filled cell's middle is, from 0
   * at the bottom of the material.
   *
   * @param n_layers  of the whole material.
   */
  template <int dim>
  class FillLayers
  {
  public:
    FillLayers(const Mesh<dim> &mesh, const unsigned int n_layers);

    unsigned int
    layer_of(const unsigned int cell) const;

    /// Level of a layer's upper side, in m.
    double
    top_of(const unsigned int layer) const;

    const unsigned int n_layers;

  private:
    const Mesh<dim> &mesh;
    double           bottom, top; ///< y of the material, in m
  };

  /// Move nodes between layers onto the level between them, as
  /// move_surface_nodes() does; in the plane.
  template <int dim>
  void
  fit_layers(Mesh<dim> &mesh, const unsigned int n_layers);

  /// The mesh when the lowest `n_filled` layers have been filled: the other
  /// cells are empty, and the surface between them is a part of the top.
  template <int dim>
  Mesh<dim>
  fill_layers(const Mesh<dim>       &mesh,
              const FillLayers<dim> &layers,
              const unsigned int     n_filled);
} // namespace Sandglass

#endif
