#ifndef sandglass_particles_seeding_h
#define sandglass_particles_seeding_h

#include <deal.II/particles/property_pool.h>

#include <sandglass/particles/cell_geometry.h>
#include <sandglass/particles/cell_moments.h>

#include <algorithm>
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
   * the id modulo N is that of the initial particle. That holds for particles
   * fed at an initial particle's place as well: each of them and its halves
   * have the next 256 of such numbers, the first ones again when all have been
   * used.
   */
  template <typename Kinematics, CellType cell_type>
  class InitialConfiguration
  {
  public:
    static constexpr int dim = Kinematics::dim;

    /// @param is_fed  whether particles are fed.
    InitialConfiguration(const Scene<dim>              &scene,
                         const CellGeometry<cell_type> &geometry,
                         const bool                     is_fed = false)
      : points(seed_points<cell_type>(scene.particles_per_cell))
      , geometry(geometry)
      , n_ids(points.size() * geometry.n_cells())
      , family_size(is_fed ? fed_family_size : largest_id / n_ids)
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
      return 2 * in_family(id / n_ids) + 3 < family_size;
    }

    /// Ids of the halves of a particle for which has_halves() holds.
    std::array<types::particle_index, 2>
    halves(const types::particle_index id) const
    {
      const types::particle_index number = id / n_ids;
      const types::particle_index first  = id + n_ids * (in_family(number) + 1);
      return {{first, first + n_ids}};
    }

    /// Id of the particle that is fed at the k-th point of a cell after so many
    /// others.
    types::particle_index
    fed_id(const unsigned int  cell,
           const unsigned int  k,
           const unsigned long n_before) const
    {
      const types::particle_index n_families =
        std::max(2u, largest_id / n_ids / family_size);
      return points.size() * cell + k +
             n_ids * family_size * (n_before % (n_families - 1) + 1);
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

    static constexpr auto largest_id =
      std::numeric_limits<types::particle_index>::max();
    /// Enough for seven halvings.
    static constexpr types::particle_index fed_family_size = 256;

    /// Of an id divided by that of the initial particles, what counts the
    /// halves of one particle.
    types::particle_index
    in_family(const types::particle_index number) const
    {
      return number % family_size;
    }

    const CellGeometry<cell_type> &geometry;
    const types::particle_index    n_ids; ///< number of initial particles
    /// How many of these numbers a particle and its halves have.
    const types::particle_index family_size;
  };
} // namespace Sandglass

#endif
