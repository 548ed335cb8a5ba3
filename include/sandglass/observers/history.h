#ifndef sandglass_observers_history_h
#define sandglass_observers_history_h

#include <sandglass/observers/csv_file.h>
#include <sandglass/observers/flow_rate.h>
#include <sandglass/observers/output_parameters.h>
#include <sandglass/observers/particle_totals.h>
#include <sandglass/observers/silo_measures.h>

#include <array>

namespace Sandglass
{
  /// Writes history.csv and, if material can leave, flow_rate.csv.
  class History
  {
  public:
    History(const OutputParameters   &parameters,
            const Scene              &scene,
            const MaterialParameters &material);

    /// Open the files, after deserialization those of the earlier run.
    void
    open();

    /**
     * Add a row to each file.
     *
     * @param critical_time_step  in s.
     */
    void
    observe(const Clock          &clock,
            const double          critical_time_step,
            const ParticleTotals &totals);

    /// Mean flow rate over the middle half of the discharge, see FlowRate.
    double
    flow_rate_plateau() const
    {
      return flow_rate.plateau();
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &history_file &flow_rate_file &flow_rate;
    }

  private:
    const bool         is_writer;
    const SiloMeasures measures;

    /// For grains of 0, 0.1 and 0.2 outlet widths, in kg/s.
    std::array<double, 3> beverloo;

    CsvFile  history_file;
    CsvFile  flow_rate_file;
    FlowRate flow_rate;
  };
} // namespace Sandglass

#endif
