#ifndef sandglass_scene_fill_surface_h
#define sandglass_scene_fill_surface_h

#include <sandglass/scene/mesh.h>
#include <sandglass/scene/scene_parameters.h>

#include <string>

namespace Sandglass
{
  /// Whether material reaches to the silo's top, and is level there.
  bool
  is_full(const SceneParameters &parameters);

  /// Throws InputError for the Fill height, with what is allowed.
  [[noreturn]] void
  refuse_fill_height(const SceneParameters &parameters,
                     const std::string     &allowed);

  /// The room that there is for material, in m.
  struct SiloExtent
  {
    double middle; ///< x
    double width;  ///< from the middle to the wall
    double top;    ///< y
    /// Of all places from the middle; 0: as of a line or a circle.
    double mean_distance = 0.;
  };

  /**
   * The material's free surface: level, or a heap that falls from the silo's
   * middle to its walls. A heap has the volume that it would have if it were
   * level at the fill height and the walls vertical, which EN 1991-4 calls the
   * equivalent surface.
   */
  template <int dim>
  class FillSurface
  {
  public:
    /// Throws InputError where it isn't below the silo's top.
    FillSurface(const SiloExtent &silo, const SceneParameters &parameters);

    /// Height y above a place, in m.
    double
    height(const dealii::Point<dim> &place) const;

  private:
    /// How far a place is from the silo's middle, in m.
    double
    distance(const dealii::Point<dim> &place) const;

    double middle; ///< x, in m
    double slope;  ///< tangent of the angle of repose
    double apex;   ///< y, in m
  };

  /**
   * Empty the filled cells above the material's surface, and let the surface
   * be a part of the top. In the plane, the nodes of the surface are moved onto
   * it as far as the cells' shapes allow it, and those around it to where the
   * cells have good shapes. Does nothing for a full silo with a level surface,
   * and for the silo that mesh_silo() has meshed along its surface.
   *
   * Throws InputError where nothing is left.
   */
  template <int dim>
  void
  fill_to_surface(Mesh<dim> &mesh, const SceneParameters &parameters);
} // namespace Sandglass

#endif
