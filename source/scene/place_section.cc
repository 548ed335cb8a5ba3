#include <sandglass/base/exceptions.h>
#include <sandglass/scene/mesh_cells.h>
#include <sandglass/scene/place_mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace Sandglass
{
  using dealii::Point;

  namespace
  {
    /// The box around some vertices.
    struct Box
    {
      static constexpr double infinity =
        std::numeric_limits<double>::infinity();

      Point<2> lower{infinity, infinity}, upper{-infinity, -infinity};

      void
      add(const Point<2> &point)
      {
        for (unsigned int d = 0; d < 2; ++d)
          {
            lower[d] = std::min(lower[d], point[d]);
            upper[d] = std::max(upper[d], point[d]);
          }
      }

      bool
      is_empty() const
      {
        return lower[0] > upper[0];
      }
    };



    Box
    box_of(const Mesh<2> &mesh, const BoundaryRole role)
    {
      Box box;
      for (const auto &edge : mesh.faces)
        if (edge.role == role)
          for (const unsigned int vertex : edge.vertices)
            box.add(mesh.vertices[vertex]);
      return box;
    }



    Box
    box_of_cells(const Mesh<2> &mesh, const bool only_filled)
    {
      Box box;
      for (const auto &cell : mesh.cells)
        if (cell.is_filled || !only_filled)
          for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
            box.add(mesh.vertices[cell.vertices[v]]);
      return box;
    }



    /// Coordinates that are closer than this are the same, in m.
    double
    rounding(const Mesh<2> &mesh)
    {
      const Box box = box_of_cells(mesh, false);
      return 1e-8 * box.lower.distance(box.upper);
    }



    /// x of the axis, if there is one.
    std::optional<double>
    find_axis(const Mesh<2> &mesh)
    {
      const Box axis = box_of(mesh, BoundaryRole::axis);
      if (axis.is_empty())
        return {};
      if (axis.upper[0] - axis.lower[0] > rounding(mesh))
        throw InputError("the physical group 'axis' is not one vertical line: "
                         "it reaches from " +
                         place(axis.lower) + " to " + place(axis.upper) +
                         "; allowed is one line x = constant (a second plane "
                         "of symmetry is a wall without friction)");
      const Box    cells = box_of_cells(mesh, false);
      const double x     = (axis.lower[0] + axis.upper[0]) / 2.;
      if (cells.lower[0] < x - rounding(mesh) &&
          cells.upper[0] > x + rounding(mesh))
        throw InputError("the mesh has cells on both sides of the physical "
                         "group 'axis' at x = " +
                         std::to_string(x) +
                         " m; allowed is a half section that ends there, or "
                         "a whole one without axis");
      return x;
    }



    /// y of the outlet's lowest point.
    double
    find_outlet_level(const Mesh<2> &mesh, std::vector<std::string> &warnings)
    {
      const Box    outlet   = box_of(mesh, BoundaryRole::outlet);
      const Box    material = box_of_cells(mesh, true);
      const double level =
        outlet.is_empty() ? material.lower[1] : outlet.lower[1];
      if (material.lower[1] >= level - rounding(mesh))
        return level;

      std::ostringstream message;
      message << "material lies below the outlet: it reaches down to y = "
              << material.lower[1] << " m, the outlet to y = " << level << " m";
      // Who fills the fall region, too, means it.
      if (std::any_of(mesh.cells.begin(),
                      mesh.cells.end(),
                      [](const auto &cell) { return !cell.is_filled; }))
        throw InputError(message.str() +
                         "; allowed is an outlet at the material's lowest "
                         "level");
      warnings.push_back("What is below the outlet counts as discharged from "
                         "the start: " +
                         message.str() + '.');
      return level;
    }



    void
    move(Mesh<2>                    &mesh,
         const dealii::Tensor<1, 2> &shift,
         std::vector<std::string>   &warnings)
    {
      if (shift.norm() == 0.)
        return;
      for (Point<2> &vertex : mesh.vertices)
        vertex += shift;
      warnings.push_back(
        "The mesh has been moved by " + place(Point<2>(shift)) +
        ", so that the axis is at x = 0 and the outlet level at y = 0; "
        "positions in the results are those after the move.");
    }



    /// In place of a negative radius.
    void
    mirror(Mesh<2> &mesh, std::vector<std::string> &warnings)
    {
      for (Point<2> &vertex : mesh.vertices)
        vertex[0] *= -1.;
      orient_cells(mesh);
      warnings.push_back("The mesh lies left of the axis and has been mirrored "
                         "there; positions in the results have x > 0.");
    }



    /// Make the fall region's border on the axis' line axis.
    void
    continue_axis(Mesh<2> &mesh)
    {
      const double distance = rounding(mesh);
      for (auto &edge : mesh.faces)
        if (is_open(edge.role) &&
            std::all_of(edge.vertices.begin(),
                        edge.vertices.end(),
                        [&](const unsigned int vertex) {
                          return std::abs(mesh.vertices[vertex][0]) < distance;
                        }))
          edge.role = BoundaryRole::axis;
    }
  } // namespace



  template <>
  void
  place_mesh<2>(Mesh<2>                  &mesh,
                const Formulation         formulation,
                std::vector<std::string> &warnings)
  {
    const double                distance = rounding(mesh);
    const std::optional<double> axis     = find_axis(mesh);
    const double                level    = find_outlet_level(mesh, warnings);
    // Rounded coordinates are left as they are.
    dealii::Tensor<1, 2> shift;
    if (axis && std::abs(*axis) > distance)
      shift[0] = -*axis;
    if (std::abs(level) > distance)
      shift[1] = -level;
    move(mesh, shift, warnings);
    if (axis || formulation == Formulation::axisymmetric)
      continue_axis(mesh);

    if (formulation != Formulation::axisymmetric)
      return;
    const Box cells = box_of_cells(mesh, false);
    if (cells.upper[0] < distance)
      mirror(mesh, warnings);
    else if (cells.lower[0] < -distance)
      throw InputError("the mesh lies on both sides of x = 0, from " +
                       place(cells.lower) + " to " + place(cells.upper) +
                       "; allowed is a half section, which Scene/Formulation = "
                       "axisymmetric turns about its axis");
    // A radius that rounding makes negative has no meaning.
    for (Point<2> &vertex : mesh.vertices)
      if (std::abs(vertex[0]) < distance)
        vertex[0] = 0.;
  }
} // namespace Sandglass
