#include <sandglass/flow/in_space.h>
#include <sandglass/output/section_corner_shares.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace Sandglass
{
  namespace
  {
    /// Tractions are continued from so many nodes.
    constexpr unsigned int n_continued = 2;

    /// How many nodes next to a corner a mesh may unload for its sake: a wall's
    /// first node, where the corner slides off it, and its second by the first.
    constexpr unsigned int most_disturbed = 2;

    /// A correction below this is no reason to touch more than the corner.
    constexpr double small_correction = 0.05;

    Tensor<1, 2>
    in_section(const Tensor<1, 3> &vector)
    {
      return Tensor<1, 2>({vector[0], vector[1]});
    }



    using Run = WallCorners::Run;

    /// How many nodes next to the corner, of `wanted` ones, can be continued
    /// from others.
    unsigned int
    n_disturbed(const Run &run, const unsigned int wanted)
    {
      if (run.n_between() <= n_continued)
        return 0;
      const unsigned int spare = run.n_between() - n_continued;
      return std::min(wanted, run.ends_in_corner ? spare / 2 : spare);
    }

    /// Over how many of them, of `wanted` ones, a correction can fade.
    unsigned int
    n_fading(const Run &run, const unsigned int wanted)
    {
      const unsigned int n = run.n_between();
      if (n == 0)
        return 0;
      return std::min(wanted, run.ends_in_corner ? n / 2 : n - 1);
    }
  } // namespace



  CornerShares::CornerShares(const Mesh<2>                 &mesh,
                             const std::vector<Wall<2>>    &walls,
                             const std::vector<WallRecord> &records)
    : records(records)
    , walls(mesh, walls, records)
  {}



  std::vector<Tensor<1, 3>>
  CornerShares::share(const std::vector<Tensor<1, 3>> &forces) const
  {
    AssertDimension(forces.size(), records.size());
    std::vector<Tensor<1, 3>> result = forces;
    for (const Corner &corner : walls.corners)
      for (const Share &share : best_shares(corner, forces))
        result[share.record] =
          in_space(records[share.record].area * share.traction);
    return result;
  }



  std::vector<CornerShares::Share>
  CornerShares::best_shares(const Corner                    &corner,
                            const std::vector<Tensor<1, 3>> &forces) const
  {
    constexpr std::array<Reach, 4> choices = {
      {{0, 0}, {0, most_disturbed}, {1, most_disturbed}, {2, most_disturbed}}};

    // Where the walls have not touched the node, they have nothing there.
    const auto is_touched = [&forces](const Run &run) {
      return forces[run.records[0]].norm() > 0.;
    };
    if (std::none_of(corner.runs.begin(), corner.runs.end(), is_touched))
      return {};

    std::optional<Shares> best;
    for (const Reach &reach : choices)
      {
        const Shares found =
          corrected(corner, expected_shares(corner, reach, forces), forces);
        if (all_press(found) && (!best || found.correction < best->correction))
          best = found;
        if (best && best->correction < small_correction)
          break;
      }
    return best ? best->shares : equal_shares(corner, forces);
  }



  Tensor<1, 2>
  CornerShares::traction_of(const unsigned int               record,
                            const std::vector<Tensor<1, 3>> &forces) const
  {
    return in_section(forces[record]) / records[record].area;
  }



  Tensor<1, 2>
  CornerShares::expected(const Run                       &run,
                         const unsigned int               n_disturbed,
                         const unsigned int               position,
                         const std::vector<Tensor<1, 3>> &forces) const
  {
    if (position > n_disturbed)
      return traction_of(run.records[position], forces);
    const unsigned int first    = n_disturbed + 1;
    const auto         distance = [&](const unsigned int i) {
      return records[run.records[i]].position.distance(
        records[run.records[0]].position);
    };
    const Tensor<1, 2> near = traction_of(run.records[first], forces);
    if (first == run.n_between())
      return near;
    const Tensor<1, 2> far = traction_of(run.records[first + 1], forces);
    return near + (distance(position) - distance(first)) /
                    (distance(first + 1) - distance(first)) * (far - near);
  }



  std::vector<CornerShares::Share>
  CornerShares::equal_shares(const Corner                    &corner,
                             const std::vector<Tensor<1, 3>> &forces) const
  {
    const auto along = [](const Tensor<1, 2> &normal) {
      return Tensor<1, 2>({-normal[1], normal[0]});
    };
    Tensor<1, 2> force, areas; // the latter with the walls' normals
    for (const Run &run : corner.runs)
      {
        const unsigned int record = run.records[0];
        force += in_section(forces[record]);
        areas += records[record].area * walls.normals[record];
      }
    double pressure = -(force * areas) / areas.norm_square();
    double friction = (force * along(areas)) / areas.norm_square();
    if (corner.is_on_axis())
      {
        pressure = -(force * corner.axis) / (areas * corner.axis);
        friction = 0.;
      }

    std::vector<Share> shares;
    for (const Run &run : corner.runs)
      {
        const Tensor<1, 2> &normal = walls.normals[run.records[0]];
        const Tensor<1, 2>  traction =
          friction * along(normal) - pressure * normal;
        shares.push_back({run.records[0], traction, traction.norm()});
      }
    return shares;
  }



  std::vector<CornerShares::Share>
  CornerShares::expected_shares(const Corner                    &corner,
                                const Reach                      reach,
                                const std::vector<Tensor<1, 3>> &forces) const
  {
    const bool         fades  = std::any_of(corner.runs.begin(),
                                   corner.runs.end(),
                                   [reach](const Run &run) {
                                     return n_fading(run, reach.n_fading) > 0;
                                   });
    std::vector<Share> shares = equal_shares(corner, forces);
    for (unsigned int r = 0; r < corner.runs.size(); ++r)
      {
        const Run         &run   = corner.runs[r];
        const unsigned int start = run.records[0];
        if (run.n_between() == 0)
          continue; // there is nothing to continue
        const unsigned int disturbed = n_disturbed(run, reach.n_disturbed);
        const unsigned int n         = n_fading(run, reach.n_fading);
        const Tensor<1, 2> traction  = expected(run, disturbed, 0, forces);
        // Where it comes to nothing beside the corner, it is nothing there.
        if (traction * walls.normals[start] >= 0.)
          {
            shares[r] = {start, Tensor<1, 2>(), 0.};
            continue;
          }
        // A run over which nothing can fade is not corrected for others'.
        const double yielding = fades && n == 0 ? 0. : traction.norm();
        shares[r]             = {start, traction, yielding};
        const auto to_end     = [&](const unsigned int record) {
          return records[record].position.distance(
            records[run.records[n + 1]].position);
        };
        for (unsigned int i = 1; i <= n; ++i)
          shares.push_back({run.records[i],
                            expected(run, disturbed, i, forces),
                            to_end(run.records[i]) / to_end(start) * yielding});
      }
    return shares;
  }



  CornerShares::Shares
  CornerShares::corrected(const Corner                    &corner,
                          std::vector<Share>               shares,
                          const std::vector<Tensor<1, 3>> &forces) const
  {
    Tensor<1, 2> missing;
    double       yielding = 0., along_axis = 0.; // in N
    const auto   direction = [](const Share &share) {
      return share.traction / share.traction.norm();
    };
    for (const Share &share : shares)
      {
        const double area = records[share.record].area;
        missing += in_section(forces[share.record]) - area * share.traction;
        yielding += area * share.yielding;
        if (corner.is_on_axis() && share.yielding > 0.)
          along_axis +=
            area * share.yielding * (direction(share) * corner.axis);
      }
    if (yielding == 0. || (corner.is_on_axis() && along_axis == 0.))
      return {shares, std::numeric_limits<double>::infinity()};

    // On the axis one component tells how much, not in which direction.
    const double of_axis =
      corner.is_on_axis() ? missing * corner.axis / along_axis : 0.;
    const Tensor<1, 2> relative = missing / yielding;
    for (Share &share : shares)
      if (share.yielding > 0.)
        share.traction +=
          share.yielding *
          (corner.is_on_axis() ? of_axis * direction(share) : relative);
    return {shares, corner.is_on_axis() ? std::abs(of_axis) : relative.norm()};
  }



  bool
  CornerShares::all_press(const Shares &found) const
  {
    return std::isfinite(found.correction) &&
           std::all_of(found.shares.begin(),
                       found.shares.end(),
                       [this](const Share &share) {
                         return share.traction * walls.normals[share.record] <=
                                0.;
                       });
  }
} // namespace Sandglass
