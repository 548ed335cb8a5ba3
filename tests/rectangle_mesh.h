#ifndef sandglass_tests_rectangle_mesh_h
#define sandglass_tests_rectangle_mesh_h

#include <sandglass/scene/mesh.h>

#include <functional>

/**
 * A rectangle of n_x times n_y squares, each one quadrilateral or two triangles
 * whose diagonals alternate or are parallel; roles of its sides, and which
 * cells are filled.
 */
struct Rectangle
{
  using Role  = Sandglass::BoundaryRole;
  using Point = dealii::Point<2>;

  Sandglass::CellType cell_type = Sandglass::CellType::triangle;
  Point               lower{0., 0.}, upper{1., 1.};
  unsigned int        n_x = 4, n_y = 4;
  Role left = Role::axis, right = Role::wall, bottom = Role::floor,
       top = Role::top;
  /// Whether all triangles' diagonals rise, instead of every other one.
  bool                               has_parallel_diagonals = false;
  std::function<bool(const Point &)> is_filled = [](const Point &) {
    return true;
  };
  /// Moves an inner vertex; its argument is the regular position.
  std::function<Point(const Point &)> displaced = [](const Point &point) {
    return point;
  };

  Sandglass::Mesh<2>
  mesh() const;

private:
  unsigned int
  vertex(const unsigned int i, const unsigned int j) const;

  void
  add_cell(Sandglass::Mesh<2>                &mesh,
           const std::array<unsigned int, 4> &vertices,
           const unsigned int                 n) const;
};

#endif
