#ifndef sandglass_tests_box_mesh_h
#define sandglass_tests_box_mesh_h

#include <sandglass/scene/mesh.h>

#include <functional>

/**
 * A box of n_x times n_y times n_z cubes, each one hexahedron or six
 * tetrahedra; roles of its sides, and which cells are filled.
 */
struct Box
{
  using Role  = Sandglass::BoundaryRole;
  using Point = dealii::Point<3>;

  Sandglass::CellType         cell_type = Sandglass::CellType::hexahedron;
  Point                       lower{0., 0., 0.}, upper{1., 1., 1.};
  std::array<unsigned int, 3> n{{4, 4, 4}};
  /// Of the sides x, y and z, first the lower one.
  std::array<std::array<Role, 2>, 3> roles{{{{Role::wall, Role::wall}},
                                            {{Role::floor, Role::top}},
                                            {{Role::wall, Role::wall}}}};
  std::function<bool(const Point &)> is_filled = [](const Point &) {
    return true;
  };
  /// Cubes, by their middle, that are left out, with the role of the sides that
  /// they leave, by the sides' middles.
  std::function<bool(const Point &)> is_left_out = [](const Point &) {
    return false;
  };
  std::function<Role(const Point &)> role_at_gap = [](const Point &) {
    return Role::wall;
  };
  /// Moves a vertex; its argument is the regular position.
  std::function<Point(const Point &)> displaced = [](const Point &point) {
    return point;
  };
  /// Whether boundary vertices move as well.
  bool displaces_boundary = false;

  Sandglass::Mesh<3>
  mesh() const;

private:
  using Place = std::array<unsigned int, 3>;

  unsigned int
  vertex(const Place &at) const;

  bool
  is_simplex() const;

  void
  add_cell(Sandglass::Mesh<3>                &mesh,
           const std::array<unsigned int, 8> &vertices) const;

  void
  add_cube(Sandglass::Mesh<3> &mesh, const Place &at) const;

  Point
  middle_of(const Place &at) const;

  bool
  exists(const Place &at) const;

  /// If it is one of the boundary.
  void
  add_side_of_cube(Sandglass::Mesh<3> &mesh,
                   const Place        &cube,
                   const unsigned int  d,
                   const unsigned int  side) const;

  static void
  leave_out_unused_vertices(Sandglass::Mesh<3> &mesh);
};

#endif
