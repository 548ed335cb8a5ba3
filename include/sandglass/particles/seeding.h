#ifndef sandglass_particles_seeding_h
#define sandglass_particles_seeding_h

#include <deal.II/particles/property_pool.h>

#include <sandglass/particles/cell_geometry.h>

#include <vector>

namespace Sandglass
{
  /**
   * Reference coordinates of a cell's initial material points: the cell's edges
   * are divided into sqrt(n) equal parts, and each of the n equal parts of the
   * cell has a point at its centroid (paper, Figure 1, for n = 4).
   */
  std::vector<Point<dim>>
  seed_points(const CellType cell_type, const unsigned int n);

  /**
   * Initial data of a particle that follow from its id alone: particle k of
   * cell c has the id n c + k, with n particles per cell. Particles therefore
   * needn't carry what never changes.
   */
  template <CellType cell_type>
  class InitialConfiguration
  {
  public:
    InitialConfiguration(const Scene                   &scene,
                         const CellGeometry<cell_type> &geometry);

    /// Position before the static stage's displacement, in m.
    Point<dim>
    position(const types::particle_index id) const
    {
      return geometry.shape(id / points.size())
        .to_real(points[id % points.size()]);
    }

    /**
     * Volume of the part of the cell that the particle stands for, in m^3
     * (plane strain: per metre of depth, axisymmetric: of the whole ring).
     */
    double
    volume(const types::particle_index id) const;

    const std::vector<Point<dim>> points;

  private:
    const Formulation              formulation;
    const CellGeometry<cell_type> &geometry;
  };
} // namespace Sandglass

#endif
