#ifndef sandglass_output_history_h
#define sandglass_output_history_h

#include <sandglass/material/material_parameters.h>
#include <sandglass/output/csv_file.h>
#include <sandglass/output/flow_pattern.h>
#include <sandglass/output/flow_rate.h>
#include <sandglass/output/flow_summary.h>
#include <sandglass/output/output_parameters.h>
#include <sandglass/output/silo_totals.h>
#include <sandglass/scene/scene.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <utility>
#include <vector>

namespace Sandglass
{
  /// What a row of history.csv is read from.
  struct HistoryRow
  {
    Clock       clock;
    double      critical_time_step; ///< in s
    SiloTotals  totals;
    FlowPattern pattern;
    bool        is_fed           = false; ///< whether something may enter
    bool        has_moving_walls = false;
  };

  /// Columns of history.csv.
  extern const std::vector<Column<HistoryRow>> history_table;

  /// What a row of flow_rate.csv is read from.
  struct FlowRateRow
  {
    double time;            ///< in s
    double discharged_mass; ///< in kg
    double rate;            ///< in kg/s
    /// Beverloo's rates for grains of 0, 0.1 and 0.2 outlet widths, in kg/s.
    std::array<double, 3> beverloo;
    /// What has passed each of several outlets, in kg.
    std::vector<double> mass_by_outlet;
  };

  /// Columns of flow_rate.csv.
  extern const std::vector<Column<FlowRateRow>> flow_rate_table;

  /// Writes history.csv and, if material can leave, flow_rate.csv.
  class History
  {
  public:
    /// @param is_fed  whether something may enter.
    template <int dim>
    History(const OutputParameters   &parameters,
            const Scene<dim>         &scene,
            const MaterialParameters &material,
            const bool                is_fed);

    /// Open the files, after deserialization those of the earlier run.
    void
    open();

    /// Add a row to each file.
    void
    add(const HistoryRow &row);

    /// How far stagnant material has moved at most, in m; 0 if nobody asks.
    double
    stagnant_displacement() const
    {
      return largest_stagnant_displacement;
    }

    /// Summary of the discharge so far; on rank 0.
    FlowSummary
    flow_summary() const;

    /// The discharged mass over time; on rank 0.
    const FlowRate &
    discharge() const
    {
      return flow_rate;
    }

    /// See FlowRateRow.
    const std::array<double, 3> &
    beverloo_rates() const
    {
      return beverloo;
    }

    /// After deserialization; see CsvFile::refuse_other(). On the writing rank.
    void
    refuse_other(const std::string &directory) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &history_file &flow_rate_file &flow_rate &slipping_samples
        &stagnant_mass;
    }

  private:
    const bool   is_writer;
    const bool   has_open_outlet;
    const double largest_stagnant_displacement;

    /// See FlowRateRow.
    std::array<double, 3> beverloo;

    CsvTable<HistoryRow>  history_file;
    CsvTable<FlowRateRow> flow_rate_file;
    FlowRate              flow_rate;

    /// A row's time in s, and its slipping share of the walls.
    std::vector<std::pair<double, double>> slipping_samples;
    /// The latest stagnant mass, in kg.
    double stagnant_mass = 0.;
  };
} // namespace Sandglass

#endif
