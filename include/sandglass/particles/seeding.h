#ifndef sandglass_particles_seeding_h
#define sandglass_particles_seeding_h

#include <deal.II/particles/property_pool.h>

#include <sandglass/particles/cell_geometry.h>
#include <sandglass/particles/cell_moments.h>

#include <array>
#include <limits>
#include <vector>

namespace Sandglass
{
  /**
   * Reference coordinates of a cell's initial material points: the cell's edges
   * are divided into sqrt(n) equal parts (in space the cubic root), and each of
   * the n equal parts of the cell has a point at its centroid (paper, Figure 1,
   * for n = 4).
   */
  template <CellType cell_type>
  std::vector<Point<CellShape<cell_type>::dim>>
  seed_points(const unsigned int n);

  template <>
  std::vector<Point<2>>
  seed_points<CellType::triangle>(const unsigned int n);
  template <>
  std::vector<Point<2>>
  seed_points<CellType::quadrilateral>(const unsigned int n);
  template <>
  std::vector<Point<3>>
  seed_points<CellType::tetrahedron>(const unsigned int n);
  template <>
  std::vector<Point<3>>
  seed_points<CellType::hexahedron>(const unsigned int n);

  /**
   * Initial data of a particle that follow from its id alone: particle k of
   * cell c has the id n c + k, with n particles per cell. Particles therefore
   * needn't carry what never changes.
   *
   * Halves of a particle have ids of their own: the N initial ones are followed
   * by N for their first halves, N for their second halves, and so on, so that
   * the id modulo N is that of the initial particle.
   */
  template <typename Kinematics, CellType cell_type>
  class InitialConfiguration
  {
  public:
    static constexpr int dim = Kinematics::dim;

    InitialConfiguration(const Scene<dim>              &scene,
                         const CellGeometry<cell_type> &geometry)
      : points(seed_points<cell_type>(scene.particles_per_cell))
      , geometry(geometry)
      , n_ids(points.size() * geometry.n_cells())
    {}

    /// Position before the static stage's displacement, in m.
    Point<dim>
    position(const types::particle_index id) const
    {
      return geometry.shape(cell(id)).to_real(points[point(id)]);
    }

    /// Whether there are ids for the halves of a particle.
    bool
    has_halves(const types::particle_index id) const
    {
      constexpr auto largest =
        std::numeric_limits<types::particle_index>::max();
      return largest / n_ids > 2 * (id / n_ids) + 3;
    }

    /// Ids of the halves of a particle for which has_halves() holds.
    std::array<types::particle_index, 2>
    halves(const types::particle_index id) const
    {
      const types::particle_index first = id + n_ids * (id / n_ids + 1);
      return {{first, first + n_ids}};
    }

    /**
     * Volume of the part of the cell that an initial particle stands for, in
     * m^3 (plane strain: per metre of depth, axisymmetric: of the whole ring).
     */
    double
    volume(const types::particle_index id) const
    {
      return part_volume<Kinematics>(geometry.shape(cell(id)),
                                     points[point(id)],
                                     points.size());
    }

    const std::vector<Point<dim>> points;

  private:
    /// Where the initial particle of an id starts.
    unsigned int
    cell(const types::particle_index id) const
    {
      return id % n_ids / points.size();
    }

    /// Which of `points` it starts from.
    unsigned int
    point(const types::particle_index id) const
    {
      return id % n_ids % points.size();
    }

    const CellGeometry<cell_type> &geometry;
    const types::particle_index    n_ids; ///< number of initial particles
  };
} // namespace Sandglass

#endif
