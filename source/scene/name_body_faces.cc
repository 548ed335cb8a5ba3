#include <deal.II/base/exceptions.h>

#include <sandglass/scene/body_cells.h>
#include <sandglass/scene/mesh_faces.h>
#include <sandglass/scene/name_body_faces.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  using dealii::Point;

  namespace
  {
    void
    remove_rounding(Mesh<3> &mesh, const SiloBody &body)
    {
      const auto put_at = [&body](double &coordinate, const double value) {
        if (std::abs(coordinate - value) < body.rounding())
          coordinate = value;
      };
      for (Point<3> &vertex : mesh.vertices)
        {
          for (const double level : {-body.fall_region_depth,
                                     0.,
                                     body.hopper_height,
                                     body.silo_height})
            put_at(vertex[1], level);
          if (body.ends_at_plane[0])
            put_at(vertex[0], 0.);
          if (body.ends_at_plane[1])
            put_at(vertex[2], 0.);
        }
    }



    /// What a face of the boundary is, by the least and largest coordinates of
    /// its vertices.
    BoundaryRole
    role_of(const Point<3> &lower, const Point<3> &upper, const SiloBody &body)
    {
      for (const unsigned int plane : {0u, 1u})
        if (body.ends_at_plane[plane] && upper[2 * plane] == 0.)
          return BoundaryRole::axis;
      if (lower[1] == body.silo_height)
        return BoundaryRole::top;
      if (upper[1] == -body.fall_region_depth)
        return BoundaryRole::fall_bottom;
      if (lower[1] < 0.)
        return BoundaryRole::fall_side;
      if (upper[1] == 0.)
        return BoundaryRole::floor;
      // The upright ends of a wedge are walls, too.
      const bool is_upright = upper[0] - lower[0] < body.rounding() ||
                              upper[2] - lower[2] < body.rounding();
      return lower[1] >= body.hopper_height || is_upright ?
               BoundaryRole::wall :
               BoundaryRole::hopper;
    }
  } // namespace



  void
  name_body_faces(Mesh<3> &mesh, const SiloBody &body)
  {
    remove_rounding(mesh, body);
    for (const auto &[vertices, cells] : cells_at_faces(mesh))
      {
        const bool is_outlet =
          cells.size() == 2 &&
          mesh.cells[cells[0]].is_filled != mesh.cells[cells[1]].is_filled;
        if (cells.size() == 2 && !is_outlet)
          continue;
        Point<3> lower = mesh.vertices[vertices[0]], upper = lower;
        for (unsigned int v = 1; v < mesh.vertices_per_face(); ++v)
          for (unsigned int d = 0; d < 3; ++d)
            {
              const double x = mesh.vertices[vertices[v]][d];
              lower[d]       = std::min(lower[d], x);
              upper[d]       = std::max(upper[d], x);
            }
        mesh.faces.push_back(
          {vertices,
           is_outlet ? BoundaryRole::outlet : role_of(lower, upper, body)});
      }
    order_faces(mesh);
  }
} // namespace Sandglass
