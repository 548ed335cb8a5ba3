#include <sandglass/scene/body_plan.h>
#include <sandglass/scene/body_plan_steps.h>

#include <algorithm>
#include <utility>

namespace Sandglass
{
  using dealii::Point;

  namespace
  {
    /// A square core and the rings around it.
    class PlanOfRings
    {
    public:
      PlanOfRings(const SiloBody &body, const Resolution &resolution)
        : body(body)
        , s_least(body.ends_at_plane[0] ? 0 : -1)
        , t_least(body.ends_at_plane[1] ? 0 : -1)
      {
        // An outline has eight halves of sides.
        const double outlet_length = body.outlet.perimeter() / 8.;
        const double wall_length   = body.wall.perimeter() / 8.;
        n = std::max(n_cells_along(outlet_length, resolution.smallest_size()),
                     n_cells_along(body.has_hopper() ?
                                     (outlet_length + wall_length) / 2. :
                                     wall_length,
                                   resolution.element_size));
        add_core();
        const double width = (1. - core_share) * body.outlet.half_width;
        add_rings(equal_steps(n_cells_along(width, outlet_length / n)), true);
        const double floor = body.wall.half_width - body.outlet.half_width;
        if (!body.has_hopper() && floor > 1e-9 * body.wall.half_width)
          add_rings(graded_steps(floor, outlet_length / n, wall_length / n),
                    false);
      }

      BodyPlan plan;

    private:
      /// Of the outline's width, what the core has on the middle lines; it
      /// bulges towards a round outline.
      static constexpr double core_share = 0.55, bulge = 0.15;

      static Point<2>
      in_core(const Outline &outline, const double s, const double t)
      {
        const double b = outline.is_round ? bulge : 0.;
        const double k = core_share / (1. + b);
        return outline.middle +
               Point<2>(k * outline.half_width * s * (1. + b * (1. - t * t)),
                        k * outline.half_depth * t * (1. + b * (1. - s * s)));
      }

      /// The outline at the foot of the wall that goes with the outlet's.
      const Outline &
      upper() const
      {
        return body.has_hopper() ? body.wall : body.outlet;
      }

      void
      add_core()
      {
        const int    first_i = s_least * int(n), first_j = t_least * int(n);
        const int    last  = n;
        unsigned int n_row = last - first_i + 1;
        const auto   index = [=](const int i, const int j) {
          return unsigned(j - first_j) * n_row + unsigned(i - first_i);
        };
        for (int j = first_j; j <= last; ++j)
          for (int i = first_i; i <= last; ++i)
            {
              const double s = double(i) / n, t = double(j) / n;
              plan.at_wall.push_back(in_core(upper(), s, t));
              plan.at_outlet.push_back(in_core(body.outlet, s, t));
            }
        for (int j = first_j; j < last; ++j)
          for (int i = first_i; i < last; ++i)
            {
              plan.cells.push_back({{index(i, j),
                                     index(i + 1, j),
                                     index(i + 1, j + 1),
                                     index(i, j + 1)}});
              plan.is_over_outlet.push_back(true);
            }
        find_border(index);
      }

      /// Around the core, without the sides in symmetry planes.
      template <typename Index>
      void
      find_border(const Index &index)
      {
        const int  last    = n;
        const int  first_i = s_least * last, first_j = t_least * last;
        const auto add = [&](const int i, const int j) {
          border.push_back(index(i, j));
          of_square.emplace_back(double(i) / n, double(j) / n);
        };
        if (t_least < 0)
          for (int i = first_i; i < last; ++i)
            add(i, -last);
        for (int j = first_j; j < last; ++j)
          add(last, j);
        for (int i = last; i > first_i; --i)
          add(i, last);
        add(first_i, last);
        if (s_least < 0)
          for (int j = last - 1; j >= first_j; --j)
            if (j > first_j || t_least == 0)
              add(first_i, j);
        is_closed = s_least < 0 && t_least < 0;
      }

      void
      add_rings(const std::vector<double> &shares, const bool is_in_outlet)
      {
        const auto place = [&](const Outline  &outline,
                               const Outline  &around,
                               const double    share,
                               const Point<2> &of_square) {
          const Point<2> inner =
            is_in_outlet ? in_core(outline, of_square[0], of_square[1]) :
                           outline.at(of_square);
          return inner + share * (around.at(of_square) - inner);
        };
        for (unsigned int ring = 1; ring < shares.size(); ++ring)
          {
            std::vector<unsigned int> next;
            for (const Point<2> &direction : of_square)
              {
                next.push_back(plan.at_wall.size());
                const auto &wall = is_in_outlet ? upper() : body.wall;
                plan.at_wall.push_back(
                  place(upper(), wall, shares[ring], direction));
                plan.at_outlet.push_back(
                  is_in_outlet ?
                    place(body.outlet, body.outlet, shares[ring], direction) :
                    plan.at_wall.back());
              }
            const unsigned int n_border = border.size();
            for (unsigned int i = 0; i < n_border - (is_closed ? 0 : 1); ++i)
              {
                const unsigned int j = (i + 1) % n_border;
                plan.cells.push_back(
                  {{border[i], next[i], next[j], border[j]}});
                plan.is_over_outlet.push_back(is_in_outlet);
              }
            border = std::move(next);
          }
      }

      const SiloBody &body;
      const int       s_least, t_least;
      unsigned int    n = 0; ///< cells along each half of a side
      /// The vertices around the plan so far, and where the square has them.
      std::vector<unsigned int> border;
      std::vector<Point<2>>     of_square;
      bool                      is_closed = false;
    };
  } // namespace



  BodyPlan
  plan_of_rings(const SiloBody &body, const Resolution &resolution)
  {
    return PlanOfRings(body, resolution).plan;
  }
} // namespace Sandglass
