#include <deal.II/base/exceptions.h>

#include <sandglass/flow/updated_lagrangian/rezoning/boundary_piece.h>
#include <sandglass/flow/updated_lagrangian/rezoning/point_locator.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Sandglass
{
  namespace
  {
    /// Barycentric coordinate down to which a point outside is evaluated in
    /// the cell.
    constexpr double lowest_coordinate = -0.1;

    double
    smallest_coordinate_of(const Point<2> &reference_point)
    {
      return std::min({reference_point[0],
                       reference_point[1],
                       1. - reference_point[0] - reference_point[1]});
    }



    /// Move a point of the reference plane into the reference triangle.
    Point<2>
    nearest_in_triangle(Point<2> p)
    {
      for (unsigned int d = 0; d < 2; ++d)
        p[d] = std::max(p[d], 0.);
      return Point<2>(p / std::max(p[0] + p[1], 1.));
    }
  } // namespace



  PointLocator::PointLocator(const TriangleMesh &mesh)
    : mesh(mesh)
  {
    constexpr double infinity = std::numeric_limits<double>::max();
    grid                      = {{infinity, infinity}, {-infinity, -infinity}};
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      {
        boxes.push_back(box_of(cell));
        for (unsigned int d = 0; d < 2; ++d)
          {
            grid.lower[d] = std::min(grid.lower[d], boxes.back().lower[d]);
            grid.upper[d] = std::max(grid.upper[d], boxes.back().upper[d]);
          }
      }
    // About a bin for each cell.
    const Tensor<1, 2> extent = grid.upper - grid.lower;
    const double width = std::sqrt(extent[0] * extent[1] / mesh.cells.size());
    for (unsigned int d = 0; d < 2; ++d)
      {
        n_bins[d]    = 1 + static_cast<unsigned int>(extent[d] / width);
        bin_width[d] = extent[d] / n_bins[d];
      }
    cells_in_bin.resize(n_bins[0] * n_bins[1]);
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      for (unsigned int i = bin(boxes[cell].lower[0], 0);
           i <= bin(boxes[cell].upper[0], 0);
           ++i)
        for (unsigned int j = bin(boxes[cell].lower[1], 1);
             j <= bin(boxes[cell].upper[1], 1);
             ++j)
          cells_in_bin[i + n_bins[0] * j].push_back(cell);
  }



  PointLocator::Box
  PointLocator::box_of(const unsigned int cell) const
  {
    Box box{mesh.nodes[mesh.cells[cell][0]], mesh.nodes[mesh.cells[cell][0]]};
    const auto include = [&box](const Point<2> &p) {
      for (unsigned int d = 0; d < 2; ++d)
        {
          box.lower[d] = std::min(box.lower[d], p[d]);
          box.upper[d] = std::max(box.upper[d], p[d]);
        }
    };
    for (unsigned int edge = 0; edge < 3; ++edge)
      {
        const QuadraticCurve curve = mesh.edge_points(cell, edge);
        include(curve[0]);
        include(bezier_corner(curve));
      }
    const double margin =
      -2. * lowest_coordinate * (box.upper - box.lower).norm();
    for (unsigned int d = 0; d < 2; ++d)
      {
        box.lower[d] -= margin;
        box.upper[d] += margin;
      }
    return box;
  }



  unsigned int
  PointLocator::bin(const double coordinate, const unsigned int direction) const
  {
    const double place =
      (coordinate - grid.lower[direction]) / bin_width[direction];
    return std::min<double>(std::max(place, 0.), n_bins[direction] - 1);
  }



  bool
  PointLocator::invert(const Point<2>    &p,
                       const unsigned int cell,
                       Point<2>          &reference_point) const
  {
    // Beyond that, where the mapping may turn over, no point is wanted.
    constexpr double farthest = 2.;

    reference_point = Point<2>(1. / 3., 1. / 3.);
    for (unsigned int i = 0; i < 30; ++i)
      {
        const Tensor<2, 2> jacobian =
          jacobian_in_cell(mesh, cell, reference_point);
        if (!(determinant(jacobian) > 0.))
          return false;
        const Tensor<1, 2> correction =
          dealii::invert(jacobian) *
          (p - position_in_cell(mesh, cell, reference_point));
        reference_point += correction;
        if (!(reference_point.norm() < farthest))
          return false;
        // The error that is left is of the order of this step's square.
        if (correction.norm() < 1e-9)
          return true;
      }
    return false;
  }



  bool
  PointLocator::find_best(const Point<2>    &p,
                          const unsigned int body,
                          Location          &location) const
  {
    location.smallest_coordinate = -std::numeric_limits<double>::max();
    for (const unsigned int cell :
         cells_in_bin[bin(p[0], 0) + n_bins[0] * bin(p[1], 1)])
      {
        if (body != numbers::invalid_unsigned_int && mesh.bodies[cell] != body)
          continue;
        const Box &box = boxes[cell];
        if (p[0] < box.lower[0] || p[0] > box.upper[0] || p[1] < box.lower[1] ||
            p[1] > box.upper[1])
          continue;
        Point<2> reference_point;
        if (!invert(p, cell, reference_point))
          continue;
        const double smallest = smallest_coordinate_of(reference_point);
        if (smallest > location.smallest_coordinate)
          location = {cell, reference_point, smallest, 0.};
      }
    return location.smallest_coordinate > -std::numeric_limits<double>::max();
  }



  Location
  PointLocator::find(const Point<2> &p, const unsigned int body) const
  {
    Location   inside{};
    const bool is_found = find_best(p, body, inside);
    if (is_found && inside.smallest_coordinate >= lowest_coordinate)
      return inside;

    const auto [index, distance]   = nearest_edge(p, body);
    const auto &[cell, edge, mark] = mesh.boundary[index];
    if (is_found)
      {
        // Where cells have turned over, a point inside may lie in none of them:
        // then the nearest cell is better than the boundary.
        inside.reference_point = nearest_in_triangle(inside.reference_point);
        inside.smallest_coordinate = 0.;
        inside.distance            = p.distance(
          position_in_cell(mesh, inside.cell, inside.reference_point));
        if (inside.distance < distance)
          return inside;
      }
    const double    t     = nearest_on_curve(mesh.edge_points(cell, edge), p);
    const Point<2> &start = reference_nodes[edge];
    const Point<2> &end   = reference_nodes[(edge + 1) % 3];
    return {cell, start + t * (end - start), 0., distance};
  }



  bool
  PointLocator::find_inside(const Point<2> &p, Location &location) const
  {
    return find_best(p, numbers::invalid_unsigned_int, location) &&
           location.smallest_coordinate >= -1e-12;
  }



  std::pair<unsigned int, double>
  PointLocator::nearest_edge(const Point<2> &p, const unsigned int body) const
  {
    std::pair<unsigned int, double> nearest(numbers::invalid_unsigned_int,
                                            std::numeric_limits<double>::max());
    for (unsigned int i = 0; i < mesh.boundary.size(); ++i)
      {
        const auto &[cell, edge, mark] = mesh.boundary[i];
        if (mesh.bodies[cell] != body)
          continue;
        const QuadraticCurve curve = mesh.edge_points(cell, edge);
        const double         distance =
          p.distance(position_on_curve(curve, nearest_on_curve(curve, p)));
        if (distance < nearest.second)
          nearest = {i, distance};
      }
    AssertThrow(nearest.first < mesh.boundary.size(),
                ExcMessage("There is no such body."));
    return nearest;
  }
} // namespace Sandglass
