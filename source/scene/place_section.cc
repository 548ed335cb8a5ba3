#include <sandglass/base/exceptions.h>
#include <sandglass/scene/mesh_box.h>
#include <sandglass/scene/mesh_cells.h>
#include <sandglass/scene/place_mesh.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace Sandglass
{
  using dealii::Point;

  namespace
  {
    /// x of the axis, if there is one.
    std::optional<double>
    find_axis(const Mesh<2> &mesh)
    {
      const MeshBox<2> axis = box_of_role(mesh, BoundaryRole::axis);
      if (axis.is_empty())
        return {};
      if (axis.upper[0] - axis.lower[0] > rounding(mesh))
        throw InputError("the physical group 'axis' is not one vertical line: "
                         "it reaches from " +
                         place(axis.lower) + " to " + place(axis.upper) +
                         "; allowed is one line x = constant (a second plane "
                         "of symmetry is a wall without friction)");
      const MeshBox<2> cells = box_of_cells(mesh, false);
      const double     x     = (axis.lower[0] + axis.upper[0]) / 2.;
      if (cells.lower[0] < x - rounding(mesh) &&
          cells.upper[0] > x + rounding(mesh))
        throw InputError("the mesh has cells on both sides of the physical "
                         "group 'axis' at x = " +
                         std::to_string(x) +
                         " m; allowed is a half section that ends there, or "
                         "a whole one without axis");
      return x;
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
    const MeshBox<2> cells = box_of_cells(mesh, false);
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
