#include <sandglass/scene/body_plan_steps.h>
#include <sandglass/scene/mesh_size.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  unsigned int
  n_cells_along(const double length, const double size)
  {
    return std::max(1., std::round(length / size));
  }



  std::vector<double>
  equal_steps(const unsigned int n)
  {
    std::vector<double> shares;
    for (unsigned int i = 0; i <= n; ++i)
      shares.push_back(double(i) / n);
    return shares;
  }



  std::vector<double>
  graded_steps(const double length, const double first, const double last)
  {
    // The integral of 1 / size, which tells how many steps there are.
    const double grows_to =
      std::min(length, std::max(0., last - first) / mesh_size_growth);
    const double at_end   = first + mesh_size_growth * grows_to;
    const auto   steps_to = [&](const double distance) {
      const double growing = std::min(distance, grows_to);
      return std::log1p(mesh_size_growth * growing / first) / mesh_size_growth +
             (distance - growing) / at_end;
    };
    const double        all      = steps_to(length);
    const unsigned int  n        = std::max(1., std::round(all));
    const double        at_grown = steps_to(grows_to);
    std::vector<double> shares;
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double steps = all * i / n;
        const double distance =
          steps <= at_grown ?
            first * std::expm1(mesh_size_growth * steps) / mesh_size_growth :
            grows_to + (steps - at_grown) * at_end;
        shares.push_back(distance / length);
      }
    shares.back() = 1.;
    return shares;
  }
} // namespace Sandglass
