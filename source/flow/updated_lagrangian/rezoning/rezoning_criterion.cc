#include <sandglass/flow/updated_lagrangian/rezoning/element_quality.h>
#include <sandglass/flow/updated_lagrangian/rezoning/point_locator.h>
#include <sandglass/flow/updated_lagrangian/rezoning/rezoning_criterion.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>

#include <sstream>

namespace Sandglass
{
  namespace
  {
    void
    keep_if_worse(WorstElement       &worst,
                  const TriangleMesh &mesh,
                  const unsigned int  cell,
                  const ElementFault  fault,
                  const double        value,
                  const double        bound)
    {
      const double quality =
        fault == ElementFault::rigid_corner ? bound / value : value / bound;
      if (quality < worst.quality)
        worst = {
          cell, middle_of_cell(mesh, cell), fault, value, bound, quality};
    }



    void
    check_rigid_corners(WorstElement            &worst,
                        const TriangleMesh      &mesh,
                        const RezoningCriterion &criterion)
    {
      const PointLocator locator(mesh);
      Location           location;
      for (const Point<2> &corner : criterion.rigid_corners)
        if (locator.find_inside(corner, location))
          {
            const auto [index, depth] =
              locator.nearest_edge(corner, mesh.bodies[location.cell]);
            const auto &[cell, edge, mark]  = mesh.boundary[index];
            const auto [start, end, middle] = mesh.edge_points(cell, edge);
            keep_if_worse(worst,
                          mesh,
                          cell,
                          ElementFault::rigid_corner,
                          depth / start.distance(end),
                          criterion.deepest_corner);
          }
    }
  } // namespace



  WorstElement
  find_worst_element(const TriangleMesh      &mesh,
                     const RezoningCriterion &criterion)
  {
    WorstElement worst;
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      {
        const double ratio = jacobian_ratio(mesh, cell);
        keep_if_worse(worst,
                      mesh,
                      cell,
                      ElementFault::jacobian,
                      ratio,
                      criterion.smallest_jacobian_ratio);
        // Angles of what has turned over say nothing.
        if (ratio > 0.)
          keep_if_worse(worst,
                        mesh,
                        cell,
                        ElementFault::angle,
                        smallest_angle(mesh, cell),
                        criterion.smallest_angle);
      }
    check_rigid_corners(worst, mesh, criterion);
    return worst;
  }



  std::string
  WorstElement::description() const
  {
    std::ostringstream text;
    text << "element " << cell << " at (" << position << ") m: ";
    switch (fault)
      {
        case ElementFault::jacobian:
          text << "smallest over largest Jacobian " << value << ", smallest is "
               << bound;
          break;
        case ElementFault::angle:
          text << "an angle of " << value / numbers::PI * 180.
               << " degrees, smallest is " << bound / numbers::PI * 180.;
          break;
        case ElementFault::rigid_corner:
          text << "a rigid corner stands in it, " << value
               << " of its edge deep, deepest is " << bound;
          break;
      }
    return text.str();
  }
} // namespace Sandglass
