#include <sandglass/particles/seeding.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    /// Into how many parts the edges are divided.
    unsigned int
    parts_of_edges(const unsigned int n)
    {
      const unsigned int parts = std::lround(std::sqrt(n));
      Assert(parts * parts == n, ExcMessage("n must be a square number"));
      return parts;
    }



    /// The same in space.
    unsigned int
    parts_of_edges_in_space(const unsigned int n)
    {
      const unsigned int parts = std::lround(std::cbrt(n));
      Assert(parts * parts * parts == n, ExcMessage("n must be a cube"));
      return parts;
    }
  } // namespace



  template <>
  std::vector<Point<2>>
  seed_points<CellType::triangle>(const unsigned int n)
  {
    const unsigned int    parts = parts_of_edges(n);
    std::vector<Point<2>> points;
    for (unsigned int j = 0; j < parts; ++j)
      for (unsigned int i = 0; i < parts; ++i)
        {
          // Upright triangles of the lattice, and those on their heads.
          if (i + j < parts)
            points.emplace_back((i + 1. / 3.) / parts, (j + 1. / 3.) / parts);
          if (i + j + 1 < parts)
            points.emplace_back((i + 2. / 3.) / parts, (j + 2. / 3.) / parts);
        }
    return points;
  }



  template <>
  std::vector<Point<2>>
  seed_points<CellType::quadrilateral>(const unsigned int n)
  {
    const unsigned int    parts = parts_of_edges(n);
    std::vector<Point<2>> points;
    for (unsigned int j = 0; j < parts; ++j)
      for (unsigned int i = 0; i < parts; ++i)
        points.emplace_back((i + 0.5) / parts, (j + 0.5) / parts);
    return points;
  }



  /**
   * The tetrahedron is the image of that of the points 1 >= x >= y >= z >= 0 of
   * the unit cube. The planes that divide a lattice of cubes into six such
   * tetrahedra each divide the large one into just n of them, all of the same
   * volume (Freudenthal 1942).
   */
  template <>
  std::vector<Point<3>>
  seed_points<CellType::tetrahedron>(const unsigned int n)
  {
    const int             parts = parts_of_edges_in_space(n);
    std::vector<Point<3>> points;
    for (int k = 0; k < parts; ++k)
      for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i)
          {
            // The paths along a cube's edges from its lowest corner to the
            // highest are the tetrahedra in it.
            std::array<int, 3> path{{0, 1, 2}};
            do
              {
                // Quarters, so that inequalities are exact.
                std::array<int, 3> corner{{i, j, k}}, sum{};
                for (int step = 0; step < 4; ++step)
                  {
                    for (int d = 0; d < 3; ++d)
                      sum[d] += corner[d];
                    if (step < 3)
                      ++corner[path[step]];
                  }
                const bool is_inside = 4 * parts > sum[0] && sum[0] > sum[1] &&
                                       sum[1] > sum[2] && sum[2] > 0;
                if (is_inside)
                  points.emplace_back((sum[0] - sum[1]) / (4. * parts),
                                      (sum[1] - sum[2]) / (4. * parts),
                                      sum[2] / (4. * parts));
              }
            while (std::next_permutation(path.begin(), path.end()));
          }
    return points;
  }



  template <>
  std::vector<Point<3>>
  seed_points<CellType::hexahedron>(const unsigned int n)
  {
    const unsigned int    parts = parts_of_edges_in_space(n);
    std::vector<Point<3>> points;
    for (unsigned int k = 0; k < parts; ++k)
      for (unsigned int j = 0; j < parts; ++j)
        for (unsigned int i = 0; i < parts; ++i)
          points.emplace_back((i + 0.5) / parts,
                              (j + 0.5) / parts,
                              (k + 0.5) / parts);
    return points;
  }
} // namespace Sandglass
