#include <deal.II/base/quadrature_lib.h>

#include <sandglass/flow/updated_lagrangian/motion/mesh_walls.h>
#include <sandglass/flow/updated_lagrangian/motion/rezoning_options.h>
#include <sandglass/flow/updated_lagrangian/motion/surface_at_walls.h>
#include <sandglass/flow/updated_lagrangian/rezoning/element_quality.h>
#include <sandglass/flow/updated_lagrangian/rezoning/smooth_surface.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    // Over the length of an element.

    /// Hollows in corners up to this are filled.
    constexpr double hollow = 0.6;
    /// Elements at the lip, and by how much they may grow from there.
    constexpr double lip_size = 0.5;



    /// Elements are as long as the material is thick, where that is less than
    /// in the silo's first mesh; but not much smaller.
    SizeField
    size_field(const MotionSetting &setting, const TriangleMesh &mesh)
    {
      constexpr double smallest  = 0.25;
      double           area      = 0.;
      double           perimeter = 0.;
      for (const double of_cell : cell_areas(mesh))
        area += of_cell;
      for (const auto &edge : mesh.boundary)
        {
          const auto curve = mesh.edge_points(edge.cell, edge.edge);
          perimeter += curve[0].distance(curve[1]);
        }
      SizeField size{std::clamp(2. * area / perimeter,
                                smallest * setting.element_size,
                                setting.element_size),
                     {}};
      for (const Point<2> &corner : rigid_corners(setting.scene, setting.walls))
        size.centres.push_back(
          {corner, std::min(size.size, lip_size * setting.element_size), 0.2});
      return size;
    }



    /**
     * Fill hollows in corners where one wall follows another: smaller than an
     * element, they can't be resolved, and would be bounded by ever smaller
     * edges.
     */
    void
    fill_corners(BoundaryLoop &loop, const MotionSetting &setting)
    {
      const double near = hollow * setting.element_size;
      const double on   = distance_on_wall * setting.element_size;
      for (const RigidWall &a : setting.walls)
        for (const RigidWall &b : setting.walls)
          {
            if (a.is_axis() || b.is_axis() || a.is_free_end[1] ||
                a.end.distance(b.start) > on)
              continue;
            const Point<2> &corner = a.end;
            // Begin the loop away from the corner.
            const auto far =
              std::find_if(loop.begin(), loop.end(), [&](const auto &piece) {
                return piece.curve[0].distance(corner) > near;
              });
            if (far == loop.end())
              continue;
            std::rotate(loop.begin(), far, loop.end());
            const unsigned int none  = numbers::invalid_unsigned_int;
            unsigned int       first = none, last = none;
            for (unsigned int i = 0; i < loop.size(); ++i)
              {
                const Point<2> &p = loop[i].curve[0];
                if (p.distance(corner) > near)
                  continue;
                if (first == none && std::abs(a.gap(p)) < on)
                  first = i;
                if (first != none && std::abs(b.gap(p)) < on)
                  last = i;
              }
            if (first == none || last == none || last <= first ||
                last - first > 20)
              continue;
            const Point<2> from = loop[first].curve[0];
            const Point<2> to   = loop[last].curve[0];
            BoundaryLoop   pieces;
            if (from.distance(corner) > on)
              pieces.push_back({straight_curve(from, corner),
                                TriangleMesh::free_surface,
                                false});
            if (to.distance(corner) > on)
              pieces.push_back({straight_curve(corner, to),
                                TriangleMesh::free_surface,
                                false});
            if (pieces.empty())
              continue;
            loop.erase(loop.begin() + first, loop.begin() + last);
            loop.insert(loop.begin() + first, pieces.begin(), pieces.end());
          }
    }
  } // namespace



  Quadrature<2>
  stress_quadrature(const unsigned int order)
  {
    if (order == 1)
      return QGaussSimplex<2>(1);
    return Quadrature<2>({Point<2>(1. / 6., 1. / 6.),
                          Point<2>(2. / 3., 1. / 6.),
                          Point<2>(1. / 6., 2. / 3.)},
                         std::vector<double>(3, 1. / 6.));
  }



  RezoningCriterion
  rezoning_criterion(const MotionSetting &setting)
  {
    RezoningCriterion criterion;
    criterion.rigid_corners = rigid_corners(setting.scene, setting.walls);
    return criterion;
  }



  RezoningOptions
  rezoning_options(const MotionSetting &setting, const TriangleMesh &mesh)
  {
    RezoningOptions options;
    options.corners.fixed_points = wall_ends(setting.walls);
    options.corners.tolerance    = distance_at_wall_end * setting.element_size;
    options.corners.mark_of      = [&setting](const BoundaryPiece &piece) {
      return wall_of(piece.curve, setting);
    };
    options.corners.change = [&setting](BoundaryLoop &loop) {
      fill_corners(loop, setting);
      turn_surface_to_walls(loop, smallest_surface_angles, setting);
      smooth_surface(loop, largest_turn_of_surface);
    };
    // Sharper turns of the surface stay, others become smooth.
    options.corners.largest_turn = 1.2;
    options.size                 = size_field(setting, mesh);
    options.quadrature           = stress_quadrature(mesh.order);
    options.depth                = setting.depth;
    // Walls and axis take up what moves sidewards.
    options.keeps_momentum = {{false, true}};
    return options;
  }
} // namespace Sandglass
