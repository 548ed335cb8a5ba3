#include <sandglass/output/replace_file.h>
#include <sandglass/study/convergence_plot.h>
#include <sandglass/study/convergence_results.h>
#include <sandglass/study/silo_study.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Sandglass
{
  const std::vector<Column<ConvergenceRow>> convergence_table = {
    {"element_size_m",
     "m",
     [](const ConvergenceRow &row) { return row.run.resolution.element_size; },
     "edge length of the cells"},
    {"particle_steps",
     "1",
     [](const ConvergenceRow &row) { return row.run.particle_steps; },
     "particles times steps"},
    {"seconds",
     "s",
     [](const ConvergenceRow &row) { return row.run.seconds; },
     "wall time of the run"},
    {"flow_rate_kg_per_s",
     "kg/s",
     [](const ConvergenceRow &row) { return row.flow_rate; },
     "mean from `window_start_s` to `window_end_s` of the study's "
     "`summary.json`; where one of the silos has emptied by then, over the "
     "middle half of the discharged mass"},
    {"error_percent",
     "1",
     [](const ConvergenceRow &row) { return 100. * row.error; },
     "difference from the extrapolated rate, in percent of that; `nan` for "
     "fewer than three runs"},
    {"outlet_element_size_m",
     "m",
     [](const ConvergenceRow &row) {
       return row.run.resolution.smallest_size();
     },
     "edge length at the outlet's lip, over which rates are extrapolated"},
    {"particles_per_cell",
     "1",
     [](const ConvergenceRow &row) {
       return static_cast<unsigned long>(row.run.resolution.particles_per_cell);
     },
     "at the start, in filled cells"},
    {"cells",
     "1",
     [](const ConvergenceRow &row) { return row.run.n_cells; },
     "of the whole mesh"},
    {"refinement",
     "1",
     [](const ConvergenceRow &row) { return row.run.refinement; },
     "`Scene/Refinement`; also in the name of the run's directory"}};



  const std::vector<Column<ConvergenceResults>> convergence_summary_table = {
    {"status",
     "",
     [](const ConvergenceResults &r) { return r.status; },
     "`running`, which a study that was killed stays; `finished`, `failed`, or "
     "`stopped` by a signal"},
    {"message",
     "",
     [](const ConvergenceResults &r) { return r.message; },
     "of the error that ended the study",
     [](const ConvergenceResults &r) { return !r.message.empty(); }},
    {"runs",
     "1",
     [](const ConvergenceResults &r) {
       return static_cast<unsigned long>(r.runs.size());
     },
     "that have come to their end"},
    {"extrapolated_flow_rate_kg_per_s",
     "kg/s",
     [](const ConvergenceResults &r) { return r.extrapolated().value; },
     "on cells of size zero, by a straight line through the runs' rates over "
     "the size of the cells at the lip; `null` for fewer than three runs"},
    {"uncertainty_kg_per_s",
     "kg/s",
     [](const ConvergenceResults &r) { return r.extrapolated().uncertainty; },
     "of that, for a probability of about 95 %: from the rates' scatter about "
     "the line, and from what a curve of second order would give instead"},
    {"window_start_s",
     "s",
     [](const ConvergenceResults &r) { return r.window_start; },
     "rates are means from this time, 3 √(D/g) with the outlet's width D,"},
    {"window_end_s",
     "s",
     [](const ConvergenceResults &r) { return r.window_end; },
     "to this one, the end of the runs;"},
    {"rate_of",
     "",
     [](const ConvergenceResults &r) {
       return std::string(r.uses_plateau() ? "plateau" : "window");
     },
     "or `plateau`: over the middle half of the discharged mass"},
    {"seconds",
     "s",
     [](const ConvergenceResults &r) {
       double seconds = 0.;
       for (const ConvergenceRun &run : r.runs)
         seconds += run.seconds;
       return seconds;
     },
     "wall time of all runs"}};



  bool
  ConvergenceResults::uses_plateau() const
  {
    return std::any_of(runs.begin(), runs.end(), [](const ConvergenceRun &run) {
      return run.has_emptied;
    });
  }



  std::vector<double>
  ConvergenceResults::flow_rates() const
  {
    const bool          is_plateau = uses_plateau();
    std::vector<double> rates;
    for (const ConvergenceRun &run : runs)
      rates.push_back(is_plateau ? run.rate_on_plateau : run.rate_in_window);
    return rates;
  }



  Extrapolation
  ConvergenceResults::extrapolated() const
  {
    std::vector<double> sizes;
    for (const ConvergenceRun &run : runs)
      sizes.push_back(run.resolution.smallest_size());
    return extrapolate(sizes, flow_rates());
  }



  std::vector<ConvergenceRow>
  ConvergenceResults::rows() const
  {
    const std::vector<double>   rates = flow_rates();
    const double                limit = extrapolated().value;
    std::vector<ConvergenceRow> result;
    for (unsigned int i = 0; i < runs.size(); ++i)
      result.push_back({runs[i], rates[i], rates[i] / limit - 1.});
    return result;
  }



  namespace
  {
    /// With this many digits, and no power of ten.
    std::string
    rounded_text(const double value, const int digits)
    {
      std::ostringstream scientific, text;
      scientific << std::scientific << std::setprecision(digits - 1) << value;
      text << std::stod(scientific.str());
      return text.str();
    }
  } // namespace



  std::string
  to_text(const Extrapolation &rate)
  {
    return rounded_text(rate.value, 4) + " \u00b1 " +
           rounded_text(rate.uncertainty, 2) + " kg/s (" +
           rounded_text(100. * rate.uncertainty / std::abs(rate.value), 2) +
           " %)";
  }



  std::string
  to_text(const ConvergenceResults &results)
  {
    std::ostringstream text;
    text
      << "    cells   at lip, m  particle-steps   seconds      kg/s    error\n";
    for (const ConvergenceRow &row : results.rows())
      text << std::setw(9) << row.run.n_cells << std::setprecision(3)
           << std::setw(12) << row.run.resolution.smallest_size()
           << std::setw(16) << static_cast<double>(row.run.particle_steps)
           << std::setw(10) << row.run.seconds << std::setprecision(4)
           << std::setw(10) << row.flow_rate << std::fixed
           << std::setprecision(1) << std::setw(7) << 100. * row.error
           << std::defaultfloat << " %\n";
    text << "On cells of size zero: " << to_text(results.extrapolated())
         << '\n';
    return text.str();
  }



  void
  write(const ConvergenceResults &results, const std::string &directory)
  {
    write_study(directory,
                convergence_table,
                results.rows(),
                convergence_summary_table,
                results);
    if (!std::isnan(results.extrapolated().value))
      replace_file(directory + "/study.svg", plot(results));
  }
} // namespace Sandglass
