#include <sandglass/output/summary.h>

#include <sys/resource.h>

#include <cmath>
#include <limits>

namespace Sandglass
{
  double
  Summary::mass_balance_error() const
  {
    const double all = initial_mass + totals.mass_fed;
    return all > 0. ? std::abs(totals.mass() - all) / all : 0.;
  }



  double
  Summary::residual_mass() const
  {
    return std::isnan(flow.discharge_time) ?
             std::numeric_limits<double>::quiet_NaN() :
             totals.mass_in_silo;
  }



  double
  peak_memory()
  {
    // Not by deal.II's get_memory_stats(), which never returns where there is
    // no /proc, as in many containers.
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024.; // from KiB
  }
} // namespace Sandglass
