#include <sandglass/base/exceptions.h>
#include <sandglass/scene/body_cells.h>
#include <sandglass/scene/mesh_cells.h>
#include <sandglass/scene/place_mesh.h>
#include <sandglass/walls/face_geometry.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// The box around some vertices.
    struct Box
    {
      static constexpr double infinity =
        std::numeric_limits<double>::infinity();

      Point<3> lower{infinity, infinity, infinity},
        upper{-infinity, -infinity, -infinity};

      void
      add(const Point<3> &point)
      {
        for (unsigned int d = 0; d < 3; ++d)
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
    box_of_cells(const Mesh<3> &mesh, const bool only_filled)
    {
      Box box;
      for (const auto &cell : mesh.cells)
        if (cell.is_filled || !only_filled)
          for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
            box.add(mesh.vertices[cell.vertices[v]]);
      return box;
    }



    Box
    box_of_face(const Mesh<3> &mesh, const Mesh<3>::Face &face)
    {
      Box box;
      for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
        box.add(mesh.vertices[face.vertices[v]]);
      return box;
    }



    /// Coordinates that are closer than this are the same, in m.
    double
    rounding(const Mesh<3> &mesh)
    {
      const Box box = box_of_cells(mesh, false);
      return 1e-8 * box.lower.distance(box.upper);
    }



    /// x and z of the symmetry planes, if there are any.
    std::array<std::optional<double>, 3>
    find_symmetry_planes(const Mesh<3> &mesh)
    {
      const double                         distance = rounding(mesh);
      const Box                            cells    = box_of_cells(mesh, false);
      std::array<std::optional<double>, 3> planes;
      for (const auto &face : mesh.faces)
        {
          if (face.role != BoundaryRole::axis)
            continue;
          const Box  box     = box_of_face(mesh, face);
          const auto lies_in = [&](const unsigned int d) {
            return box.upper[d] - box.lower[d] <= distance &&
                   (!planes[d] ||
                    std::abs(box.lower[d] - *planes[d]) <= 2. * distance);
          };
          const unsigned int d = lies_in(0) ? 0 : 2;
          if (!lies_in(d))
            throw InputError("a face of the physical group 'axis', from " +
                             place(box.lower) + " to " + place(box.upper) +
                             ", lies in no symmetry plane; allowed are one "
                             "plane x = constant and one z = constant");
          planes[d] = box.lower[d];
          if (cells.lower[d] < *planes[d] - distance &&
              cells.upper[d] > *planes[d] + distance)
            throw InputError(
              "the mesh has cells on both sides of the physical group 'axis' "
              "at " +
              place(box.lower) +
              "; allowed is a half or a quarter that ends there, or a whole "
              "silo without symmetry planes");
        }
      return planes;
    }



    /// y of the outlet's lowest point.
    double
    find_outlet_level(const Mesh<3> &mesh, std::vector<std::string> &warnings)
    {
      Box outlet;
      for (const auto &face : mesh.faces)
        if (face.role == BoundaryRole::outlet)
          for (unsigned int v = 0; v < mesh.vertices_per_face(); ++v)
            outlet.add(mesh.vertices[face.vertices[v]]);
      const Box    material = box_of_cells(mesh, true);
      const double level =
        outlet.is_empty() ? material.lower[1] : outlet.lower[1];
      if (material.lower[1] >= level - rounding(mesh))
        return level;
      std::ostringstream message;
      message << "material lies below the outlet: it reaches down to y = "
              << material.lower[1] << " m, the outlet to y = " << level << " m";
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
  } // namespace



  template <>
  void
  place_mesh<3>(Mesh<3> &mesh,
                const Formulation,
                std::vector<std::string> &warnings)
  {
    const double distance = rounding(mesh);
    const auto   planes   = find_symmetry_planes(mesh);
    const double level    = find_outlet_level(mesh, warnings);
    // Rounded coordinates are left as they are.
    dealii::Tensor<1, 3> shift;
    for (const unsigned int d : {0u, 2u})
      if (planes[d] && std::abs(*planes[d]) > distance)
        shift[d] = -*planes[d];
    if (std::abs(level) > distance)
      shift[1] = -level;
    if (shift.norm() > 0.)
      {
        for (Point<3> &vertex : mesh.vertices)
          vertex += shift;
        warnings.push_back(
          "The mesh has been moved by " + place(Point<3>(shift)) +
          ", so that symmetry planes are at x = 0 and z = 0 and the outlet "
          "level at y = 0; positions in the results are those after the move.");
      }
    // A symmetry plane goes on below the outlet, where particles must not pass.
    for (auto &face : mesh.faces)
      if (is_open(face.role))
        for (const unsigned int d : {0u, 2u})
          if (const Box box = box_of_face(mesh, face);
              planes[d] && std::abs(box.lower[d]) < distance &&
              std::abs(box.upper[d]) < distance)
            face.role = BoundaryRole::axis;
    order_faces(mesh);
  }
} // namespace Sandglass
