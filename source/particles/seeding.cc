#include <sandglass/particles/cell_moments.h>
#include <sandglass/particles/seeding.h>

#include <cmath>

namespace Sandglass
{
  std::vector<Point<dim>>
  seed_points(const CellType cell_type, const unsigned int n)
  {
    const unsigned int parts = std::lround(std::sqrt(n));
    Assert(parts * parts == n, ExcMessage("n must be a square number"));

    std::vector<Point<dim>> points;
    for (unsigned int j = 0; j < parts; ++j)
      for (unsigned int i = 0; i < parts; ++i)
        if (cell_type == CellType::quadrilateral)
          points.emplace_back((i + 0.5) / parts, (j + 0.5) / parts);
        else
          {
            // Upright triangles of the lattice, and those on their heads.
            if (i + j < parts)
              points.emplace_back((i + 1. / 3.) / parts, (j + 1. / 3.) / parts);
            if (i + j + 1 < parts)
              points.emplace_back((i + 2. / 3.) / parts, (j + 2. / 3.) / parts);
          }
    return points;
  }



  template <CellType cell_type>
  InitialConfiguration<cell_type>::InitialConfiguration(
    const Scene                   &scene,
    const CellGeometry<cell_type> &geometry)
    : points(seed_points(cell_type, scene.particles_per_cell))
    , formulation(scene.formulation)
    , geometry(geometry)
    , n_ids(points.size() * geometry.n_cells())
  {}



  template <CellType cell_type>
  double
  InitialConfiguration<cell_type>::volume(const types::particle_index id) const
  {
    return part_volume(geometry.shape(cell(id)),
                       formulation,
                       points[point(id)],
                       points.size());
  }



  template class InitialConfiguration<CellType::triangle>;
  template class InitialConfiguration<CellType::quadrilateral>;
} // namespace Sandglass
