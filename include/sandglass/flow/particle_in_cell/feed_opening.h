#ifndef sandglass_flow_particle_in_cell_feed_opening_h
#define sandglass_flow_particle_in_cell_feed_opening_h

#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/flow/particle_in_cell/feed_parameters.h>
#include <sandglass/particles/particle_blocks.h>
#include <sandglass/particles/seeding.h>
#include <sandglass/scene/feed_cells.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace Sandglass
{
  /// The cells through which particles enter, what room there is in them, and
  /// the particles that are to enter.
  template <typename Setting>
  class FeedOpening
  {
  public:
    static constexpr int dim = Setting::dim;

    using Kinematics    = typename Setting::Kinematics;
    using Layout        = typename Setting::Layout;
    using Configuration = InitialConfiguration<Kinematics, Setting::cell_type>;
    using Blocks        = ParticleBlocks<Layout>;
    using Block         = ParticleBlock<Layout>;
    using Parcel        = Sandglass::Parcel<Layout>;

    /// Throws InputError where there are no such cells. See Feed.
    FeedOpening(const Scene<dim>          &scene,
                const Configuration       &initial_configuration,
                const double               density,
                const std::vector<double> &law_state,
                const FeedParameters      &parameters)
      : initial_configuration(initial_configuration)
      , density(density)
      , law_state(law_state)
    {
      if (parameters.kind == FeedKind::none)
        return;
      const auto of_kind = parameters.kind == FeedKind::level ?
                             surface_cells(scene.mesh) :
                             top_cells(scene.mesh);
      for (const unsigned int cell : of_kind)
        if (parameters.is_in_opening(middle_of_cell(scene.mesh, cell)[0]))
          cells.push_back(cell);
      if (cells.empty())
        throw InputError("Feed",
                         "Opening left",
                         parameters.left ? std::to_string(*parameters.left) :
                                           "",
                         "no cell of the material's surface or the mesh's top "
                         "lies in the opening; allowed are places between the "
                         "silo's walls");
      for (const unsigned int cell : cells)
        is_own.push_back(scene.cell_owners[cell] ==
                         Utilities::MPI::this_mpi_process(scene.communicator));
    }

    /// Of a particle at a cell's place, in kg.
    double
    mass(const unsigned int cell, const unsigned int k) const
    {
      return density * initial_configuration.volume(id(cell, k));
    }

    /// Of the initial particle there.
    types::particle_index
    id(const unsigned int cell, const unsigned int k) const
    {
      return initial_configuration.points.size() * cell + k;
    }

    /// Of a cell's initial particles, on average, in m^3.
    double
    mean_volume(const unsigned int cell) const
    {
      const unsigned int n   = initial_configuration.points.size();
      double             sum = 0.;
      for (unsigned int k = 0; k < n; ++k)
        sum += initial_configuration.volume(id(cell, k));
      return sum / n;
    }

    /// Volume of a cell that its particles leave, in m^3; those of `entering`
    /// count.
    double
    free_volume(const Blocks &blocks, const unsigned int cell) const
    {
      double volume = 0.;
      for (unsigned int k = 0; k < initial_configuration.points.size(); ++k)
        volume += initial_configuration.volume(id(cell, k));
      blocks.for_each_in_cell(cell, [&](const ParticleSlot &slot) {
        const auto &values = blocks[slot.block].values;
        volume -=
          values[Block::mass][slot.lane] / values[Block::density][slot.lane];
      });
      for (const Parcel &parcel : entering)
        if (parcel.cell == cell)
          volume -= parcel.properties[Layout::mass] /
                    parcel.properties[Layout::density];
      return volume;
    }

    /// The particles' mean velocity in m/s; zero where there are none.
    Tensor<1, dim>
    mean_velocity(const Blocks &blocks, const unsigned int cell) const
    {
      double         sum = 0.;
      Tensor<1, dim> momentum;
      blocks.for_each_in_cell(cell, [&](const ParticleSlot &slot) {
        const double mass = blocks[slot.block].values[Block::mass][slot.lane];
        sum += mass;
        momentum += mass * blocks[slot.block].point(Block::velocity, slot.lane);
      });
      return sum > 0. ? momentum / sum : momentum;
    }

    /// Which of a cell's initial places is farthest from its particles.
    unsigned int
    emptiest_place(const Blocks &blocks, const unsigned int cell) const
    {
      unsigned int emptiest = 0;
      double       largest  = -1.;
      for (unsigned int k = 0; k < initial_configuration.points.size(); ++k)
        {
          const Point<dim> place = initial_configuration.position(id(cell, k));
          double           nearest = std::numeric_limits<double>::max();
          blocks.for_each_in_cell(cell, [&](const ParticleSlot &slot) {
            nearest =
              std::min(nearest,
                       place.distance_square(
                         blocks[slot.block].point(Block::location, slot.lane)));
          });
          for (const Parcel &parcel : entering)
            if (parcel.cell == cell)
              nearest =
                std::min(nearest, place.distance_square(parcel.location));
          if (nearest > largest)
            {
              emptiest = k;
              largest  = nearest;
            }
        }
      return emptiest;
    }

    /// @param n_before  how many have been fed at this place.
    void
    add(const unsigned int    cell,
        const unsigned int    k,
        const unsigned long   n_before,
        const Tensor<1, dim> &velocity)
    {
      Parcel parcel{};
      parcel.cell            = cell;
      parcel.id              = initial_configuration.fed_id(cell, k, n_before);
      parcel.reference_point = initial_configuration.points[k];
      parcel.location        = initial_configuration.position(parcel.id);
      parcel.properties[Layout::mass]    = mass(cell, k);
      parcel.properties[Layout::density] = density;
      for (unsigned int d = 0; d < dim; ++d)
        parcel.properties[Layout::velocity + d] = velocity[d];
      std::copy_n(law_state.begin(),
                  Layout::n_law_numbers,
                  parcel.properties.begin() + Layout::law_state);
      entering.push_back(parcel);
    }

    const Configuration &initial_configuration;
    const double         density; ///< of the unstressed material, in kg/m^3

    std::vector<unsigned int> cells;  ///< on all ranks
    std::vector<bool>         is_own; ///< which of them this rank has

    /// Kept between steps to avoid allocation.
    std::vector<Parcel> entering;

  private:
    const std::vector<double> law_state;
  };
} // namespace Sandglass

#endif
