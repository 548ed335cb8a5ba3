#ifndef sandglass_tests_irregular_square_h
#define sandglass_tests_irregular_square_h

#include "random_engine.h"
#include "rectangle_mesh.h"

/// A unit square of n_cells^2 quadrilaterals, or twice as many triangles, for
/// orders of convergence. Regular meshes are kinder to stresses than those in
/// use, so each inner vertex is moved by up to a fifth of a cell in both
/// directions. Sides and bottom hold in their normal direction.
inline Sandglass::Mesh<2>
irregular_square(const Sandglass::CellType cell_type,
                 const unsigned int        n_cells)
{
  auto                                   engine = random_engine();
  std::uniform_real_distribution<double> share(-0.2, 0.2);
  Rectangle                              rectangle;
  rectangle.cell_type = cell_type;
  rectangle.n_x = rectangle.n_y = n_cells;
  rectangle.left = rectangle.right = Sandglass::BoundaryRole::axis;
  rectangle.bottom                 = Sandglass::BoundaryRole::axis;
  rectangle.displaced              = [&](const dealii::Point<2> &regular) {
    const double x = share(engine), y = share(engine);
    return regular + dealii::Tensor<1, 2>({x / n_cells, y / n_cells});
  };
  return rectangle.mesh();
}

#endif
