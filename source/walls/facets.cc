#include <sandglass/walls/facets.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    /// Give all of some faces the direction of their mean.
    void
    unite(Facets<3> &facets, const std::vector<unsigned int> &which)
    {
      Tensor<1, 3> mean;
      for (const unsigned int f : which)
        mean += facets[f].area * facets[f].normal;
      if (!(mean.norm() > 0.))
        return;
      mean /= mean.norm();
      for (const unsigned int f : which)
        facets[f].normal = mean;
    }



    /// Faces of one wall that stand for a curved surface hold their node in one
    /// direction, its normal.
    void
    smooth_walls(Facets<3> &facets)
    {
      // Cells of a cylinder turn by less from one to the next, even where four
      // make a quarter of it; sides of a pyramid or a square silo by more.
      constexpr double smallest_cosine = 0.82;

      std::vector<bool> is_done(facets.size(), false);
      for (unsigned int first = 0; first < facets.size(); ++first)
        {
          if (is_done[first] || facets[first].wall == no_wall)
            continue;
          is_done[first] = true;
          std::vector<unsigned int> surface{first};
          for (unsigned int i = 0; i < surface.size(); ++i)
            for (unsigned int f = 0; f < facets.size(); ++f)
              if (!is_done[f] && facets[f].wall == facets[first].wall &&
                  facets[f].normal * facets[surface[i]].normal >
                    smallest_cosine)
                {
                  is_done[f] = true;
                  surface.push_back(f);
                }
          const bool is_plane =
            std::all_of(surface.begin(), surface.end(), [&](const auto f) {
              return facets[f].normal * facets[first].normal > same_direction;
            });
          if (!is_plane)
            unite(facets, surface);
        }
    }



    /// One face of each direction.
    std::vector<unsigned int>
    find_directions(const Facets<3> &facets)
    {
      std::vector<unsigned int> directions;
      for (unsigned int f = 0; f < facets.size(); ++f)
        if (std::none_of(
              directions.begin(), directions.end(), [&](const auto d) {
                return facets[d].normal * facets[f].normal > same_direction &&
                       (facets[d].wall == no_wall) ==
                         (facets[f].wall == no_wall);
              }))
          directions.push_back(f);
      return directions;
    }



    /// Where walls have more directions than space, as in the corner of a
    /// pyramid below a square silo, unite those nearest to each other, all
    /// pairs of them that are as near.
    void
    unite_nearest_directions(Facets<3> &facets)
    {
      constexpr double rounding = 1e-6;
      for (auto directions = find_directions(facets); directions.size() > 3;
           directions      = find_directions(facets))
        {
               double nearest = -1.;
               for (const unsigned int a : directions)
            for (const unsigned int b : directions)
              if (a < b && facets[a].wall != no_wall &&
                  facets[b].wall != no_wall)
                nearest =
                  std::max(nearest, facets[a].normal * facets[b].normal);
          if (nearest <= 0.)
            return;
          const Facets<3> before = facets;
               for (const unsigned int a : directions)
            for (const unsigned int b : directions)
              if (a < b && before[a].wall != no_wall &&
                  before[b].wall != no_wall &&
                  before[a].normal * before[b].normal > nearest - rounding)
                {
                       std::vector<unsigned int> both;
                       for (unsigned int f = 0; f < facets.size(); ++f)
                    if (before[f].wall != no_wall &&
                        (before[f].normal * before[a].normal > same_direction ||
                         before[f].normal * before[b].normal > same_direction))
                      both.push_back(f);
                  unite(facets, both);
                }
        }
    }
  } // namespace



  void
  unite_directions(Facets<3> &facets)
  {
    smooth_walls(facets);
    unite_nearest_directions(facets);
  }
} // namespace Sandglass
