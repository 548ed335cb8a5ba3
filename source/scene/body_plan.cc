#include <sandglass/scene/body_plan.h>
#include <sandglass/scene/body_plan_steps.h>

#include <algorithm>

namespace Sandglass
{
  using dealii::Point;

  namespace
  {
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
  } // namespace



  BodyPlan
  make_body_plan(const SiloBody &body, const Resolution &resolution)
  {
    if (!body.wall.is_round && !body.outlet.is_round)
      return plan_of_rows(body, resolution);
    return plan_of_rings(body, resolution);
  }
} // namespace Sandglass
