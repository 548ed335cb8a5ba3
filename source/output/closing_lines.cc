#include <sandglass/output/closing_lines.h>

#include <cctype>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// Four digits: more than the results are sure of.
    std::string
    rounded(const double value)
    {
      std::ostringstream text;
      text << std::setprecision(4) << value;
      return text.str();
    }



    /// Behind a quantity of the whole silo: in plane strain it is that of a
    /// metre of depth.
    std::string
    unit(const Summary &summary, const std::string &of_all)
    {
      const bool is_plane = summary.formulation == Formulation::plane_strain;
      return !is_plane ? of_all : of_all == "kg/s" ? "kg/(s m)" : of_all + "/m";
    }



    std::string
    masses(const Summary &summary)
    {
      std::string text =
        "Discharged " + rounded(summary.totals.mass_discharged()) + " of " +
        rounded(summary.initial_mass) + ' ' + unit(summary, "kg") + "; " +
        rounded(summary.totals.mass_in_silo) +
        (std::isnan(summary.flow.discharge_time) ?
           " still in the silo when the run ended" :
           " stays in the silo");
      if (summary.is_fed)
        text += "; " + rounded(summary.totals.mass_fed) + " fed";
      if (summary.totals.mass_lost > 0.)
        text += "; " + rounded(summary.totals.mass_lost) + " lost";
      return text + '\n';
    }



    std::string
    flow_rate(const Summary &summary, const std::array<double, 3> &beverloo)
    {
      if (std::isnan(summary.flow.plateau))
        return "Nothing has flowed\n";
      return "Flow rate " + rounded(summary.flow.plateau) + ' ' +
             unit(summary, "kg/s") +
             " over the middle half of the discharge; Beverloo's is " +
             rounded(beverloo[0]) + " with fine grains, " +
             rounded(beverloo[1]) + " with grains of 0.1 outlet widths\n";
    }



    std::string
    kind_of_flow(const Summary &summary)
    {
      const FlowKind &kind = *summary.flow_kind;
      std::string     text = kind.name;
      text[0]              = static_cast<char>(std::toupper(text[0]));
      if (!std::isnan(kind.transition))
        text += ": material stands beside the wall up to y = " +
                rounded(kind.transition) + " m";
      if (!std::isnan(summary.flow.slipping_wall_share))
        text += "; " + rounded(100. * summary.flow.slipping_wall_share) +
                " % of the walls' area slips";
      return text + '\n';
    }



    std::string
    pressure(const LargestPressure &largest)
    {
      const auto in_kPa = [](const double value) {
        return rounded(value / 1000.) + " kPa";
      };
      std::string text = "Largest wall pressure " + in_kPa(largest.pressure) +
                         " on '" + largest.wall +
                         "' at x = " + rounded(largest.x) +
                         " m, y = " + rounded(largest.y) +
                         " m, t = " + rounded(largest.time) + " s";
      if (!std::isnan(largest.eurocode))
        text +=
          "; EN 1991-4 has " + in_kPa(largest.eurocode) + " there at discharge";
      return text + '\n';
    }
  } // namespace



  std::string
  report_command(const std::string &directory)
  {
    return "sandglass-report " + directory;
  }



  std::string
  closing_lines(const Summary               &summary,
                const std::array<double, 3> &beverloo,
                const std::string           &directory)
  {
    std::string text;
    if (!summary.ended_by.empty())
      text += "Ended at t = " + rounded(summary.clock.time) +
              " s: " + summary.ended_by + '\n';
    if (summary.has_flow_rate)
      text += masses(summary) + flow_rate(summary, beverloo);
    if (summary.flow_kind && !summary.flow_kind->name.empty())
      text += kind_of_flow(summary);
    if (summary.largest_pressure && summary.largest_pressure->is_known())
      text += pressure(*summary.largest_pressure);
    return text + "Results are in " + directory +
           "; a page with all of them: " + report_command(directory) + '\n';
  }
} // namespace Sandglass
