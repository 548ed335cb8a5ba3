#ifndef sandglass_flow_particle_in_cell_particle_splitting_h
#define sandglass_flow_particle_in_cell_particle_splitting_h

#include <sandglass/flow/particle_in_cell/nodal_sums.h>
#include <sandglass/flow/particle_in_cell/particle_stage_parameters.h>
#include <sandglass/particles/cell_moments.h>
#include <sandglass/particles/seeding.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace Sandglass
{
  /// Volume of a cell's largest initial particle, in m^3.
  template <typename Configuration>
  double
  largest_seeded_volume(const Configuration &initial_configuration,
                        const unsigned int   cell)
  {
    const unsigned int n      = initial_configuration.points.size();
    double             result = 0.;
    for (unsigned int k = 0; k < n; ++k)
      result = std::max(result, initial_configuration.volume(n * cell + k));
    return result;
  }

  /// Whether the filled cells' volumes differ so much that light particles meet
  /// heavy ones. Plane meshes of one size have areas within a factor of four,
  /// tetrahedra of one size volumes within a factor of ten.
  template <int dim, typename Configuration>
  bool
  cells_differ_much(const Mesh<dim>     &mesh,
                    const Configuration &initial_configuration)
  {
    constexpr double largest_ratio = dim == 2 ? 6. : 12.;
    double           smallest      = std::numeric_limits<double>::max();
    double           largest       = 0.;
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      if (mesh.cells[cell].is_filled)
        {
          const double volume =
            largest_seeded_volume(initial_configuration, cell);
          smallest = std::min(smallest, volume);
          largest  = std::max(largest, volume);
        }
    return largest > largest_ratio * smallest;
  }

  /**
   * Halves particles that are too large for the cells that they have come to,
   * which otherwise hold few or none: in graded meshes, and next to the axis,
   * where rings are small (doc/graded-meshes.md).
   *
   * Too large means more than 1.5 times the largest mass that a particle starts
   * with in that cell. The halves have the parent's velocity, stress and
   * density, and lie on both sides of where it was, along the principal
   * extension of the deformation, since the gaps are there. So mass, momentum,
   * angular momentum, energy and centre of mass stay as they are. Particles
   * less dense than `smallest_density`, separated ones, are left alone.
   */
  template <typename Setting>
  class ParticleSplitting
  {
  public:
    static constexpr int dim = Setting::dim;

    using Kinematics    = typename Setting::Kinematics;
    using Layout        = typename Setting::Layout;
    using Shape         = typename Setting::Shape;
    using Geometry      = CellGeometry<Setting::cell_type>;
    using Configuration = InitialConfiguration<Kinematics, Setting::cell_type>;
    using Blocks        = ParticleBlocks<Layout>;
    using Block         = ParticleBlock<Layout>;
    using Parcel        = Sandglass::Parcel<Layout>;

    /// Steps between two looks. The fastest particles cross a small cell in
    /// about as many.
    static constexpr unsigned int interval = 16;

    /**
     * @param full_density      of unstressed material, in kg/m^3.
     * @param smallest_density  of particles that are halved, in kg/m^3.
     */
    ParticleSplitting(const Geometry      &geometry,
                      const Configuration &initial_configuration,
                      const double         full_density,
                      const double         smallest_density,
                      const bool           is_on)
      : geometry(geometry)
      , initial_configuration(initial_configuration)
      , smallest_density(smallest_density)
    {
      if (!is_on)
        return;
      for (unsigned int cell = 0; cell < geometry.n_cells(); ++cell)
        largest_mass.push_back(
          largest_share * full_density *
          largest_seeded_volume(initial_configuration, cell));
    }

    bool
    is_on() const
    {
      return !largest_mass.empty();
    }

    /**
     * @param velocity  v^L of step 7 in m/s, with its ghosts.
     * @param changed   is called with each cell in which particles were halved.
     */
    template <typename Changed>
    void
    split(Blocks                &blocks,
          const NodalField<dim> &velocity,
          const Changed         &changed)
    {
      for_each_filled_cell(blocks, [&](const unsigned int cell) {
        find_large_particles(blocks, cell);
        if (large.empty())
          return;
        const auto direction = principal_extension(cell, velocity);
        halves.clear();
        for (const ParticleSlot &slot : large)
          halve(slot, direction, blocks);
        for (const Parcel &half : halves)
          blocks.insert(half);
        if (!halves.empty())
          changed(cell);
      });
    }

  private:
    /// Largest mass that is not halved, over the largest one that a particle
    /// starts with in the cell.
    static constexpr double largest_share = 1.5;

    /// Distance of a half from its parent, over the root of the parent's area
    /// (the cubic root of its volume).
    static constexpr double reach = 0.3;

    /// Smallest face distance of a half, in cells.
    static constexpr double margin = 1e-3;

    void
    find_large_particles(const Blocks &blocks, const unsigned int cell)
    {
      large.clear();
      blocks.for_each_block_in_cell(cell, [&](const unsigned int block) {
        const auto is_large =
          (blocks[block].load(Block::mass) > Lanes(largest_mass[cell])) &
          is_dense(load_state(blocks[block]), smallest_density);
        if (any(is_large))
          for (unsigned int lane = 0; lane < blocks.n_lanes(block); ++lane)
            if (is_large[lane])
              large.push_back({cell, block, lane});
      });
    }

    /// Unit vector along which the cell's middle is stretched most.
    Tensor<1, dim>
    principal_extension(const unsigned int     cell,
                        const NodalField<dim> &velocity) const
    {
      const auto gradient = gradient_of(gather(velocity, geometry.nodes(cell)),
                                        geometry.shape(cell).shape_gradients(
                                          point_within<Shape>()));
      return point_of(Kinematics::principal_extension(gradient));
    }

    /// One half takes the parent's slot, the other goes to `halves`; nothing
    /// happens next to the cell's faces, where there is no room.
    void
    halve(const ParticleSlot   &slot,
          const Tensor<1, dim> &direction,
          Blocks               &blocks)
    {
      const Parcel parent = blocks.parcel(slot);
      if (!initial_configuration.has_halves(parent.id))
        return;
      const auto  &points = initial_configuration.points;
      const double smallest =
        0.5 * reach *
        length_of(
          part_area(geometry.shape(slot.cell), points[0], points.size()));
      for (double distance = reach * length_of(area(parent));
           distance > smallest;
           distance *= 0.5)
        {
          const auto both = halves_of(parent, distance * direction);
          if (Geometry::is_inside(both[0].reference_point, margin) &&
              Geometry::is_inside(both[1].reference_point, margin))
            {
              blocks.overwrite(slot, both[0]);
              halves.push_back(both[1]);
              return;
            }
        }
    }

    std::array<Parcel, 2>
    halves_of(const Parcel &parent, const Tensor<1, dim> &offset) const
    {
      const auto            ids = initial_configuration.halves(parent.id);
      std::array<Parcel, 2> both{{parent, parent}};
      for (unsigned int i = 0; i < both.size(); ++i)
        {
          both[i].id = ids[i];
          both[i].location += i == 0 ? offset : -offset;
          both[i].reference_point =
            geometry.shape(parent.cell).to_reference(both[i].location);
          both[i].properties[Layout::mass] *= 0.5;
        }
      return both;
    }

    /// Of a square of that area in m^2, or a cube of that volume in m^3.
    static double
    length_of(const double area)
    {
      return dim == 2 ? std::sqrt(area) : std::cbrt(area);
    }

    /// Area of a particle in the section, in m^2; in space its volume, in m^3.
    static double
    area(const Parcel &particle)
    {
      const double volume = particle.properties[Layout::mass] /
                            particle.properties[Layout::density];
      return volume / Kinematics::measure(particle.location);
    }

    const Geometry      &geometry;
    const Configuration &initial_configuration;
    const double         smallest_density;
    std::vector<double>  largest_mass; ///< in each cell, kg; none: off

    /// Kept between calls to avoid allocation.
    std::vector<ParticleSlot> large;
    std::vector<Parcel>       halves;
  };
} // namespace Sandglass

#endif
