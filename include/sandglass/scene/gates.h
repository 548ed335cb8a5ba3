#ifndef sandglass_scene_gates_h
#define sandglass_scene_gates_h

#include <sandglass/scene/gate_parameters.h>
#include <sandglass/scene/mesh.h>
#include <sandglass/scene/outlets.h>

#include <vector>

namespace Sandglass
{
  /**
   * Gates in a mesh's outlets. Where one is closed, the cells above and below
   * the outlet have nodes of their own, so that the outlet's faces are a wall
   * for what lies on them, and what has fallen through goes on falling.
   */
  template <int dim>
  class Gates
  {
  public:
    /// Which faces of the mesh are closed.
    using ClosedFaces = std::vector<bool>;

    /**
     * Throws InputError where gates name an outlet that the mesh lacks, or open
     * from a side that half a section hasn't.
     *
     * @param mesh  with all outlets open; has to live as long.
     */
    Gates(const Mesh<dim> &mesh, const GateParameters &parameters);

    bool
    are_on() const
    {
      return parameters.are_on();
    }

    /// A face is closed unless its middle is in the open part; empty without
    /// gates.
    ClosedFaces
    closed_at(const double time) const;

    /**
     * The mesh with these faces closed. Cells have the same indices, and so
     * have vertices; those for the faces' lower sides come last.
     */
    Mesh<dim>
    close(const ClosedFaces &closed) const;

  private:
    /// Where an outlet begins and ends (x), in m.
    struct Extent
    {
      double left, right;
    };

    bool
    is_in_opening(const double  x,
                  const Extent &extent,
                  const double  share) const;

    const Mesh<dim>          &mesh;
    const GateParameters     &parameters;
    const std::vector<Outlet> outlets;
    std::vector<Extent>       extents; ///< of the outlets
    bool                      has_axis;
  };
} // namespace Sandglass

#endif
