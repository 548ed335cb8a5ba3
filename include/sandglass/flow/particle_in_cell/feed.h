#ifndef sandglass_flow_particle_in_cell_feed_h
#define sandglass_flow_particle_in_cell_feed_h

#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/flow/clock.h>
#include <sandglass/flow/particle_in_cell/feed_opening.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace Sandglass
{
  /**
   * Particles that enter while others flow: unstressed, where cells of an
   * opening would have theirs at the start, and as large. They enter at cells
   * that have room for them, so their mass is that of the material that they
   * add.
   *
   * With FeedKind::level the cells are those at the material's first surface.
   * As much enters as has passed the outlets, where there is most room, with
   * the velocity of those that are there. (To fill cells, each or all together,
   * whenever they have room lets in up to a third too much: there are now more
   * particles, now fewer, and who enters near the cell's bottom leaves it
   * early.) With FeedKind::rain the cells are those at the grid's
   * top. Each of their places gets a particle in turn, when its mass is due;
   * what finds no room then stays outside, so that a full silo takes no more.
   */
  template <typename Setting>
  class Feed
  {
  public:
    static constexpr int dim = Setting::dim;

    using Opening       = FeedOpening<Setting>;
    using Configuration = typename Opening::Configuration;
    using Blocks        = typename Opening::Blocks;
    using Block         = typename Opening::Block;
    using Parcel        = typename Opening::Parcel;

    /**
     * Throws InputError where there is no opening, or one too narrow for the
     * rate.
     *
     * @param density    of the unstressed material, in kg/m^3.
     * @param law_state  of the unstressed material.
     */
    Feed(const Scene<dim>          &scene,
         const Configuration       &initial_configuration,
         const double               density,
         const std::vector<double> &law_state,
         const FeedParameters      &parameters)
      : parameters(parameters)
      , rate(parameters.rate / scene.symmetry_factor)
      , communicator(scene.communicator)
      , opening(scene, initial_configuration, density, law_state, parameters)
    {
      if (parameters.kind == FeedKind::rain)
        {
          check_rate(scene);
          order_places();
        }
      else if (parameters.kind == FeedKind::level)
        {
          for (const unsigned int cell : opening.cells)
            mean_volumes.push_back(opening.mean_volume(cell));
          for (unsigned int cell = 0; cell < scene.mesh.cells.size(); ++cell)
            if (scene.cell_owners[cell] ==
                  Utilities::MPI::this_mpi_process(scene.communicator) &&
                middle_of_cell(scene.mesh, cell)[1] < 0.)
              cells_below_outlet.push_back(cell);
        }
    }

    bool
    is_on() const
    {
      return parameters.kind != FeedKind::none;
    }

    /**
     * This rank's particles that enter in the step of this clock; valid until
     * the next call. Collective.
     *
     * @param mass_left  what has left the grid and has not been fed, on this
     *   rank, in kg.
     */
    const std::vector<Parcel> &
    due(const Blocks &blocks, const Clock &clock, const double mass_left)
    {
      opening.entering.clear();
      if (parameters.kind == FeedKind::rain)
        let_it_rain(blocks, clock);
      else if (parameters.is_on_at(clock.time))
        keep_level(blocks,
                   Utilities::MPI::sum(mass_left + falling_mass(blocks),
                                       communicator));
      return opening.entering;
    }

    /// See ParticleStage; none of rain, whose numbers follow from the time.
    FedNumbers
    fed_numbers() const
    {
      return {n_fed.begin(), n_fed.end()};
    }

    /// @param numbers  of all ranks.
    void
    set_fed_numbers(const FedNumbers &numbers)
    {
      n_fed.clear();
      for (const auto &[place, n] : numbers)
        for (unsigned int i = 0; i < opening.cells.size(); ++i)
          if (opening.is_own[i] &&
              opening.cells[i] ==
                place / opening.initial_configuration.points.size())
            n_fed[place] = n;
    }

  private:
    /// What has passed the outlets but not left the grid, in kg.
    double
    falling_mass(const Blocks &blocks) const
    {
      double sum = 0.;
      for (const unsigned int cell : cells_below_outlet)
        blocks.for_each_in_cell(cell, [&](const ParticleSlot &slot) {
          sum += blocks[slot.block].values[Block::mass][slot.lane];
        });
      return sum;
    }

    /// @param mass_due  of all ranks, in kg.
    void
    keep_level(const Blocks &blocks, double mass_due)
    {
      // Each rank comes to the same cells: rounding decides nothing.
      constexpr double rounding = 1e-9;
      const double     least =
        *std::min_element(mean_volumes.begin(), mean_volumes.end());
      if (mass_due < opening.density * least * (1. - rounding))
        return;
      std::vector<double> room = room_in_cells(blocks);
      while (true)
        {
          const double largest = *std::max_element(room.begin(), room.end());
          const unsigned int i =
            std::find_if(room.begin(),
                         room.end(),
                         [&](const double volume) {
                           return volume >= largest - rounding * least;
                         }) -
            room.begin();
          const double needed = mean_volumes[i] * (1. - rounding);
          if (mass_due < opening.density * needed || room[i] < needed)
            return;
          mass_due -= opening.density * mean_volumes[i];
          room[i] -= mean_volumes[i];
          if (opening.is_own[i])
            fill_up(blocks, opening.cells[i]);
        }
    }

    /// In each cell of the opening, in m^3, known on all ranks.
    std::vector<double>
    room_in_cells(const Blocks &blocks) const
    {
      std::vector<double> room(opening.cells.size(), 0.);
      for (unsigned int i = 0; i < opening.cells.size(); ++i)
        if (opening.is_own[i])
          room[i] = opening.free_volume(blocks, opening.cells[i]);
      // The other ranks add zero.
      Utilities::MPI::sum(room, communicator, room);
      return room;
    }

    /// Let a particle in at a cell's emptiest place.
    void
    fill_up(const Blocks &blocks, const unsigned int cell)
    {
      const unsigned int k = opening.emptiest_place(blocks, cell);
      opening.add(cell,
                  k,
                  n_fed[opening.id(cell, k)]++,
                  opening.mean_velocity(blocks, cell));
    }

    void
    let_it_rain(const Blocks &blocks, const Clock &clock)
    {
      Tensor<1, dim> velocity;
      velocity[1]              = -parameters.speed;
      const unsigned long last = n_due(clock.time + clock.time_step);
      for (unsigned long i = n_due(clock.time); i < last; ++i)
        {
          const Place &place = places[i % places.size()];
          if (place.is_own && opening.free_volume(blocks, place.cell) >=
                                opening.initial_configuration.volume(
                                  opening.id(place.cell, place.k)))
            opening.add(place.cell, place.k, i / places.size(), velocity);
        }
    }

    /// How many particles have been due up to a time in s.
    unsigned long
    n_due(const double time) const
    {
      const double end =
        parameters.end ? std::min(time, *parameters.end) : time;
      const double mass = rate * (end - parameters.start);
      if (mass <= 0.)
        return 0;
      const double of_all = places.back().mass_up_to;
      const double rounds = std::floor(mass / of_all);
      const auto   next =
        std::upper_bound(places.begin(),
                         places.end(),
                         mass - rounds * of_all,
                         [](const double due, const Place &place) {
                           return due < place.mass_up_to;
                         });
      return static_cast<unsigned long>(rounds) * places.size() +
             (next - places.begin());
    }

    /// Refuse a rate that the opening doesn't let through at this speed.
    void
    check_rate(const Scene<dim> &scene) const
    {
      const double largest =
        opening.density * parameters.speed *
        opening_area(scene.mesh, opening.cells, scene.formulation);
      if (rate <= largest)
        return;
      std::ostringstream value, allowed;
      value << parameters.rate;
      allowed << "allowed are at most " << largest * scene.symmetry_factor
              << " kg/s, the density times the Speed and the opening's area";
      throw InputError("Feed", "Rate", value.str(), allowed.str());
    }

    /// In an order in which those that follow each other are far apart.
    void
    order_places()
    {
      constexpr double   golden = 0.6180339887498949;
      const unsigned int n      = opening.initial_configuration.points.size();
      std::vector<std::pair<double, Place>> ordered;
      for (unsigned int i = 0; i < opening.cells.size(); ++i)
        for (unsigned int k = 0; k < n; ++k)
          {
            const double turn = golden * ordered.size();
            ordered.push_back({turn - std::floor(turn),
                               {opening.cells[i], k, opening.is_own[i], 0.}});
          }
      std::stable_sort(ordered.begin(),
                       ordered.end(),
                       [](const auto &a, const auto &b) {
                         return a.first < b.first;
                       });
      double mass_up_to = 0.;
      for (auto &[turn, place] : ordered)
        {
          mass_up_to += opening.mass(place.cell, place.k);
          place.mass_up_to = mass_up_to;
          places.push_back(place);
        }
    }

    /// Where rain enters.
    struct Place
    {
      unsigned int cell, k;
      bool         is_own;     ///< whether this rank has the cell
      double       mass_up_to; ///< in a round, this place's included, in kg
    };

    const FeedParameters &parameters;
    const double          rate; ///< of the grid, in kg/s
    const MPI_Comm        communicator;
    Opening               opening;

    std::vector<Place> places; ///< of rain, on all ranks
    /// Of particles in the opening's cells, in m^3, where a level is kept.
    std::vector<double> mean_volumes;
    /// Of this rank.
    std::vector<unsigned int> cells_below_outlet;

    /// By the id of the initial particle at a place, how many have been fed
    /// there on this rank.
    std::map<unsigned int, unsigned int> n_fed;
  };
} // namespace Sandglass

#endif
