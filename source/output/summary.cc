#include <deal.II/base/utilities.h>

#include <sandglass/output/summary.h>

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
    dealii::Utilities::System::MemoryStats statistics;
    dealii::Utilities::System::get_memory_stats(statistics);
    return statistics.VmHWM / 1024.;
  }
} // namespace Sandglass
