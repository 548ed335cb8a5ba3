#include <sandglass/particles/seeding.h>

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
} // namespace Sandglass
