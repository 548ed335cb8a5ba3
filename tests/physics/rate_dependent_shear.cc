// Steady flows of the law mu(I) that are alike along their length, by the
// particle stage, against closed forms.

#include <sandglass/material/mu_i.h>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <vector>

#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  constexpr double g = 9.81, density = 1500., grain_density = 2500.; // SI
  constexpr double width = 1.; // of the flow, in m
  /// It does nothing but set the rate: the strain after which the flow is
  /// steady, three with these grains, grows with the square of width over
  /// diameter.
  constexpr double grain_diameter = 0.5;                  // m
  constexpr double slow_angle = 20.9, fast_angle = 32.76; // degrees
  constexpr double number_of_half = 0.278;                // I_0

  const double slow = std::tan(radians(slow_angle)),
               fast = std::tan(radians(fast_angle));

  /// Shear rate over inertial number, sqrt(p / rho_s) / d, in 1/s.
  double
  rate_scale(const double pressure)
  {
    return std::sqrt(pressure / grain_density) / grain_diameter;
  }

  /**
   * A flow without ends in squares. Of equal parts in a row, each two cells
   * long, the middle one is the flow: after each step its particles replace
   * those of all others, so that it has the neighbours that it would have in a
   * row without ends. Only friction keeps a memory of its own at the nodes; the
   * parts are so many that what the ends do to it doesn't come to the middle.
   */
  class EndlessFlow
  {
  public:
    /// @param along    direction of the flow: 0 for a layer, whose floor is
    ///                 rough and whose top is free, 1 for half a tube between
    ///                 its axis and a rough wall.
    /// @param n_cells  across the flow.
    EndlessFlow(const unsigned int  along,
                const unsigned int  n_cells,
                const Tensor<1, 2> &gravity)
      : along(along)
      , h(width / n_cells)
    {
      fixture.gravity                          = gravity;
      fixture.material.model                   = MuI::name;
      fixture.material.density                 = density;
      fixture.material.young_modulus           = 1e3 * density * g * width;
      fixture.material.internal_friction_angle = slow_angle;
      fixture.material.law_constants           = {{"d", grain_diameter},
                                                  {"rho_s", grain_density},
                                                  {"phi_2", fast_angle},
                                                  {"I_0", number_of_half}};
      fixture.walls.friction_angle             = 89.; // nothing slips
      fixture.parameters.end_time              = 1e3;
      fixture.start(mesh(n_cells));
      find_places();
    }

    /// Start without motion, from a pressure for each distance across.
    template <typename Function>
    void
    set_pressure(const Function &pressure)
    {
      const double bulk_modulus = fixture.elasticity().bulk_modulus();
      fixture.stage->start_from(
        [&](const unsigned int cell, const Point<2> &reference) {
          const double p =
            pressure(fixture.scene->mapping.transform_unit_to_real_cell(
              cells[cell], reference)[1 - along]);
          return InitialState<2>{{},
                                 isotropic<4>(-p),
                                 std::exp(-p / bulk_modulus)};
        },
        {});
      repeat([this](const auto &parcel) {
        return places[parcel.cell].part == middle;
      });
    }

    void
    run(const double end_time)
    {
      while (fixture.stage->view().clock().time < end_time)
        {
          fixture.stage->step();
          repeat(
            [](const auto &parcel) { return parcel.id % n_parts == middle; });
        }
    }

    /// Root mean square of the middle's nodes' difference from a velocity
    /// profile, over that of the profile.
    template <typename Function>
    double
    error(const Function &exact) const
    {
      const auto &velocities = fixture.stage->nodal_fields().mapped_velocity;
      double      difference = 0., scale = 0.;
      fixture.for_each_node([&](const auto &position, const unsigned int node) {
        const double distance = position[along] - 0.5 * n_along * h;
        if (std::abs(distance) > 1.1 * h || position[1 - along] > 1.01 * width)
          return;
        const double velocity = exact(position[1 - along]);
        difference += std::pow(velocities.at(node)[along] - velocity, 2);
        scale += velocity * velocity;
      });
      return std::sqrt(difference / scale);
    }

  private:
    static constexpr unsigned int part_length = 2; // cells
    static constexpr unsigned int n_parts = 17, middle = n_parts / 2;
    /// A cell stays empty at each end.
    static constexpr unsigned int n_along = part_length * n_parts + 2;

    /// Which part a cell is in, and the same place in all parts.
    struct Place
    {
      unsigned int              part = numbers::invalid_unsigned_int;
      std::vector<unsigned int> cells;
    };

    Mesh<2>
    mesh(const unsigned int n_cells) const
    {
      Rectangle rectangle;
      rectangle.cell_type = CellType::quadrilateral;
      rectangle.n_x       = along == 0 ? n_along : n_cells;
      rectangle.n_y       = along == 0 ? n_cells + 1 : n_along;
      rectangle.upper     = Point<2>(rectangle.n_x * h, rectangle.n_y * h);
      rectangle.right = along == 0 ? BoundaryRole::axis : BoundaryRole::wall;
      rectangle.is_filled = [this](const Point<2> &center) {
        return center[along] > h && center[along] < (n_along - 1) * h &&
               center[1 - along] < width;
      };
      return rectangle.mesh();
    }

    void
    find_places()
    {
      for (const auto &cell :
           fixture.scene->triangulation.active_cell_iterators())
        cells.push_back(cell);
      places.resize(cells.size());
      for (const auto &cell : cells)
        for (const auto &other : cells)
          {
            const Tensor<1, 2> way   = other->center() - cell->center();
            const unsigned int n     = cell->center()[along] / h;
            const double       parts = way[along] / (part_length * h);
            if (n == 0 || n == n_along - 1 ||
                std::abs(way[1 - along]) > 0.1 * h)
              continue;
            Place       &place = places[cell->active_cell_index()];
            const double part  = (n - 1) / part_length + parts;
            place.part         = (n - 1) / part_length;
            place.cells.resize(n_parts);
            if (std::abs(part - std::round(part)) < 0.1 && part > -0.1 &&
                part < n_parts - 0.9)
              place.cells[std::lround(part)] = other->active_cell_index();
          }
    }

    /// Let all parts have the particles of the middle. They are told from their
    /// copies by their ids, since they may have come to the next part.
    template <typename Function>
    void
    repeat(const Function &is_of_middle)
    {
      fixture.stage->edit_blocks([&](auto &blocks) {
        parcels.clear();
        blocks.for_each([&](const ParticleSlot &slot) {
          auto         parcel = blocks.parcel(slot);
          const Place &place  = places[slot.cell];
          if (!is_of_middle(parcel))
            return;
          const unsigned int id = parcels.size();
          const double       at = parcel.location[along];
          for (unsigned int part = 0; part < n_parts; ++part)
            {
              parcel.id   = id + part;
              parcel.cell = place.cells[part];
              parcel.location[along] =
                at + part_length * h * (double(part) - double(place.part));
              parcels.push_back(parcel);
            }
        });
        blocks.clear();
        for (const auto &parcel : parcels)
          blocks.insert(parcel);
      });
    }

    StageFixture                                        fixture;
    const unsigned int                                  along;
    const double                                        h;
    std::vector<Triangulation<2>::active_cell_iterator> cells;
    std::vector<Place>                                  places;
    std::vector<Parcel<StageLayout>>                    parcels;
  };



  /// tau / p is tan(angle) everywhere, so that the rate is that of one number:
  /// Bagnold's profile.
  double
  error_of_layer(const unsigned int n_cells)
  {
    const double angle  = radians(25.);
    const double weight = density * g * std::cos(angle); // N/m^3
    const double number =
      number_of_half * (std::tan(angle) - slow) / (fast - std::tan(angle));
    EndlessFlow layer(
      0, n_cells, Tensor<1, 2>({g * std::sin(angle), -g * std::cos(angle)}));
    layer.set_pressure([&](const double y) { return weight * (width - y); });
    layer.run(6.);
    return layer.error([&](const double y) {
      return 2. / 3. * number * rate_scale(weight) *
             (std::pow(width, 1.5) - std::pow(std::max(width - y, 0.), 1.5));
    });
  }



  /// The pressure is the same everywhere, tau = rho g x. Up to s = tau / p =
  /// mu_s nothing shears; the integral of I / I_0 = (s - mu_s) / (mu_2 - s) by
  /// s is -s - (mu_2 - mu_s) log(mu_2 - s).
  double
  error_of_tube(const unsigned int n_cells)
  {
    constexpr double at_wall  = 0.55; // tau / p
    const double     pressure = density * g * width / at_wall;
    EndlessFlow      tube(1, n_cells, Tensor<1, 2>({0., -g}));
    tube.set_pressure([&](const double) { return pressure; });
    tube.run(6.);
    const auto integral = [](const double s) {
      return -s - (fast - slow) * std::log(fast - s);
    };
    return tube.error([&](const double x) {
      const double s = std::max(at_wall * x / width, slow);
      return -number_of_half * rate_scale(pressure) * width / at_wall *
             (integral(at_wall) - integral(s));
    });
  }
} // namespace



TEST(EndlessFlow, LayerOnASlopeHasBagnoldsProfile)
{
  for (const unsigned int n_cells : {8, 16})
    {
      const double error = error_of_layer(n_cells);
      std::cout << "layer on a slope, " << n_cells << " cells: velocity error "
                << error << std::endl;
      EXPECT_LT(error, 0.01);
    }
}



// The edge of the plug is as sharp as the cells.
TEST(EndlessFlow, TubeHasAPlugAndShearsAtItsWall)
{
  for (const unsigned int n_cells : {8, 16})
    {
      const double error = error_of_tube(n_cells);
      std::cout << "tube, " << n_cells << " cells: velocity error " << error
                << std::endl;
      EXPECT_LT(error, n_cells == 8 ? 0.1 : 0.01);
    }
}
