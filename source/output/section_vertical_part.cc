#include <sandglass/output/section_outline.h>
#include <sandglass/output/section_vertical_part.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Sandglass
{
  namespace
  {
    /// Which vertices the material has at the start.
    std::vector<bool>
    find_filled(const Mesh<2> &mesh)
    {
      std::vector<bool> is_filled(mesh.vertices.size(), false);
      for (const auto &cell : mesh.cells)
        if (cell.is_filled)
          for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
            is_filled[cell.vertices[v]] = true;
      return is_filled;
    }



    bool
    points_down(const Tensor<1, 2> &gravity)
    {
      return -gravity[1] > 0. &&
             std::abs(gravity[0]) <= small_sine * gravity.norm();
    }
  } // namespace



  VerticalPart::VerticalPart(const Scene<2> &scene)
    : top(scene.fill_top)
    , bottom(scene.fill_bottom)
  {
    if (!points_down(scene.gravity))
      return;
    const std::vector<bool> is_filled = find_filled(scene.mesh);
    std::vector<Point<2>>   points;
    for (unsigned int v = 0; v < scene.mesh.vertices.size(); ++v)
      if (is_filled[v])
        points.push_back(scene.mesh.vertices[v]);
    find_sides(scene, points);
    if (sides.empty())
      return;

    std::vector<Edge> edges;
    for (const auto &edge : scene.mesh.faces)
      {
        const WallId wall = boundary_part(scene.walls, edge.boundary_id()).wall;
        if (wall == no_wall || edge.role == BoundaryRole::outlet ||
            !is_filled[edge.vertices[0]] || !is_filled[edge.vertices[1]])
          continue;
        Point<2> lower = scene.mesh.vertices[edge.vertices[0]];
        Point<2> upper = scene.mesh.vertices[edge.vertices[1]];
        if (lower[1] > upper[1])
          std::swap(lower, upper);
        edges.push_back({lower, upper, wall});
      }
    find_foot(edges);
    if (foot > top - rounding)
      {
        width = 0.;
        return;
      }
    CommonFriction friction;
    for (const Edge &edge : edges)
      if (is_part_of_side(edge) && edge.upper[1] > foot + rounding)
        friction.add(scene.walls[edge.wall]);
    friction_coefficient = friction.value();
    has_flat_bottom      = bottom > foot - rounding;
    find_hopper(scene, edges);
    find_outlet(scene);
  }



  void
  VerticalPart::find_sides(const Scene<2>              &scene,
                           const std::vector<Point<2>> &points)
  {
    Range all, surface, axis_range;
    for (const Point<2> &point : points)
      all.add(point[0]);
    rounding = small_sine * all.length();
    for (const Point<2> &point : points)
      if (point[1] > top - rounding)
        surface.add(point[0]);
    for (const auto &edge : scene.mesh.faces)
      for (const unsigned int vertex : edge.vertices)
        {
          const Point<2> &point = scene.mesh.vertices[vertex];
          if (edge.role == BoundaryRole::axis)
            axis_range.add(point[0]);
          // A surface that is not level.
          if (edge.role == BoundaryRole::top && point[1] < top - rounding)
            return;
        }
    if (surface.length() <= rounding || axis_range.length() > rounding)
      return;
    if (axis_range.upper >= axis_range.lower)
      axis = axis_range.middle();

    const bool is_round = scene.formulation == Formulation::axisymmetric;
    if (is_round && axis && std::abs(*axis) > rounding)
      return;
    for (const double x : {surface.lower, surface.upper})
      if (!axis || std::abs(x - *axis) > rounding)
        sides.push_back(x);
    width = sides.size() == 1 ? 2. * surface.length() : surface.length();
    hydraulic_radius = width / (is_round && sides.size() == 1 ? 4. : 2.);
    is_plain         = !is_round || sides.size() == 1;
  }



  void
  VerticalPart::find_foot(const std::vector<Edge> &edges)
  {
    // The upper ends of what is no part of the sides, and their lower ends.
    foot = bottom;
    std::vector<double> ends(sides.size(),
                             std::numeric_limits<double>::infinity());
    for (const Edge &edge : edges)
      if (!is_part_of_side(edge))
        foot = std::max(foot, edge.upper[1]);
      else
        for (unsigned int s = 0; s < sides.size(); ++s)
          if (std::abs(edge.lower[0] - sides[s]) <= rounding)
            ends[s] = std::min(ends[s], edge.lower[1]);
    for (const double end : ends)
      foot = std::max(foot, end);
    for (const double end : ends)
      is_plain = is_plain && end > foot - rounding;
  }



  bool
  VerticalPart::is_side(const double x) const
  {
    return std::any_of(sides.begin(), sides.end(), [&](const double side) {
      return std::abs(x - side) <= rounding;
    });
  }



  bool
  VerticalPart::is_part_of_side(const Edge &edge) const
  {
    const Tensor<1, 2> along = edge.upper - edge.lower;
    return is_side(edge.lower[0]) && is_side(edge.upper[0]) &&
           std::abs(along[0]) <= small_sine * along.norm();
  }



  bool
  VerticalPart::has_wall(const WallRecord &record) const
  {
    return width > 0. && std::abs(record.normal[1]) <= small_sine &&
           is_side(record.position[0]) &&
           record.position[1] > foot - rounding &&
           record.position[1] < top + rounding;
  }



  bool
  VerticalPart::has_bottom(const WallRecord &record) const
  {
    return width > 0. && has_flat_bottom &&
           std::abs(record.normal[0]) <= small_sine &&
           record.position[1] < foot + rounding;
  }



  bool
  VerticalPart::has_hopper(const WallRecord &record) const
  {
    return hopper_slope > 0. && std::abs(record.normal[0]) > small_sine &&
           std::abs(record.normal[1]) > small_sine &&
           record.position[1] < foot + rounding;
  }
} // namespace Sandglass
