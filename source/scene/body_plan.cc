#include <sandglass/scene/body_plan.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  using dealii::Point;

  namespace
  {
    /// As for tetrahedra: see grade_mesh_size().
    constexpr double growth = 0.2;



    unsigned int
    n_cells_along(const double length, const double size)
    {
      return std::max(1., std::round(length / size));
    }



    /// Places of the plan's lines in one direction, at the level of the wall's
    /// foot and at that of the outlet.
    struct Lines
    {
      std::vector<double> at_wall, at_outlet;
      /// Of the rows between lines.
      std::vector<bool> is_over_outlet;
    };



    /// From `begin`, which the lines have already, to `end`.
    void
    add_rows(Lines                     &lines,
             const double               begin,
             const double               end,
             const std::vector<double> &shares,
             const bool                 is_over_outlet)
    {
      for (unsigned int i = 1; i < shares.size(); ++i)
        {
          lines.at_wall.push_back(begin + shares[i] * (end - begin));
          lines.is_over_outlet.push_back(is_over_outlet);
        }
    }



    std::vector<double>
    mirrored(const std::vector<double> &shares)
    {
      std::vector<double> result;
      for (auto share = shares.rbegin(); share != shares.rend(); ++share)
        result.push_back(1. - *share);
      return result;
    }



    std::vector<double>
    equal_steps(const unsigned int n)
    {
      std::vector<double> shares;
      for (unsigned int i = 0; i <= n; ++i)
        shares.push_back(double(i) / n);
      return shares;
    }



    /**
     * The lines in one direction.
     *
     * @param ends_in_middle  at a symmetry plane.
     * @param has_lips        in this direction: the ends of a slot have none.
     */
    Lines
    make_lines(const double      half_width,
               const double      outlet_half_width,
               const double      outlet_middle,
               const bool        ends_in_middle,
               const bool        has_hopper,
               const bool        has_lips,
               const Resolution &resolution)
    {
      const double left = ends_in_middle ? 0. : -half_width;
      const double outlet_left =
        ends_in_middle ? 0. : outlet_middle - outlet_half_width;
      const double outlet_right = outlet_middle + outlet_half_width;
      const double size         = resolution.element_size;
      const double at_lip       = has_lips ? resolution.smallest_size() : size;

      Lines lines;
      lines.at_wall = {left};
      if (has_hopper || !has_lips)
        {
          const double outlet_width = outlet_right - outlet_left;
          const double mean_width =
            (half_width - left + outlet_right - outlet_left) / 2.;
          const unsigned int n = std::max(n_cells_along(outlet_width, at_lip),
                                          n_cells_along(mean_width, size));
          add_rows(lines, left, half_width, equal_steps(n), true);
          for (const double share : equal_steps(n))
            lines.at_outlet.push_back(outlet_left + share * outlet_width);
          return lines;
        }
      const double rounding = 1e-9 * half_width;
      if (outlet_left - left > rounding)
        add_rows(lines,
                 left,
                 outlet_left,
                 mirrored(graded_steps(outlet_left - left, at_lip, size)),
                 false);
      add_rows(lines,
               outlet_left,
               outlet_right,
               equal_steps(n_cells_along(outlet_right - outlet_left, at_lip)),
               true);
      if (half_width - outlet_right > rounding)
        add_rows(lines,
                 outlet_right,
                 half_width,
                 graded_steps(half_width - outlet_right, at_lip, size),
                 false);
      lines.at_outlet = lines.at_wall;
      return lines;
    }



    BodyPlan
    plan_of_rows(const SiloBody &body, const Resolution &resolution)
    {
      const Lines        along_x = make_lines(body.wall.half_width,
                                       body.outlet.half_width,
                                       body.outlet.middle[0],
                                       body.ends_at_plane[0],
                                       body.has_hopper(),
                                       true,
                                       resolution);
      const Lines        along_z = make_lines(body.wall.half_depth,
                                       body.outlet.half_depth,
                                       body.outlet.middle[1],
                                       body.ends_at_plane[1],
                                       body.has_hopper(),
                                       !body.outlet_is_slot,
                                       resolution);
      BodyPlan           plan;
      const unsigned int n = along_x.at_wall.size();
      for (unsigned int j = 0; j < along_z.at_wall.size(); ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            plan.at_wall.emplace_back(along_x.at_wall[i], along_z.at_wall[j]);
            plan.at_outlet.emplace_back(along_x.at_outlet[i],
                                        along_z.at_outlet[j]);
          }
      for (unsigned int j = 0; j + 1 < along_z.at_wall.size(); ++j)
        for (unsigned int i = 0; i + 1 < n; ++i)
          {
            const unsigned int v = j * n + i;
            plan.cells.push_back({{v, v + 1, v + n + 1, v + n}});
            plan.is_over_outlet.push_back(along_x.is_over_outlet[i] &&
                                          along_z.is_over_outlet[j]);
          }
      return plan;
    }



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



  std::vector<double>
  graded_steps(const double length, const double first, const double last)
  {
    // The integral of 1 / size, which tells how many steps there are.
    const double grows_to =
      std::min(length, std::max(0., last - first) / growth);
    const double at_end   = first + growth * grows_to;
    const auto   steps_to = [&](const double distance) {
      const double growing = std::min(distance, grows_to);
      return std::log1p(growth * growing / first) / growth +
             (distance - growing) / at_end;
    };
    const double        all      = steps_to(length);
    const unsigned int  n        = std::max(1., std::round(all));
    const double        at_grown = steps_to(grows_to);
    std::vector<double> shares;
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double steps    = all * i / n;
        const double distance = steps <= at_grown ?
                                  first * std::expm1(growth * steps) / growth :
                                  grows_to + (steps - at_grown) * at_end;
        shares.push_back(distance / length);
      }
    shares.back() = 1.;
    return shares;
  }



  BodyPlan
  make_body_plan(const SiloBody &body, const Resolution &resolution)
  {
    if (!body.wall.is_round && !body.outlet.is_round)
      return plan_of_rows(body, resolution);
    return PlanOfRings(body, resolution).plan;
  }
} // namespace Sandglass
