#include <sandglass/base/parameter_entries.h>
#include <sandglass/output/progress.h>
#include <sandglass/study/convergence_plan.h>
#include <sandglass/study/convergence_results.h>
#include <sandglass/study/convergence_study.h>
#include <sandglass/study/silo_study.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <string>
#include <vector>

namespace Sandglass
{
  namespace
  {
    /// A study that would take longer leaves its finest meshes out; wall time
    /// in s.
    constexpr double longest_study = 4. * 3600.;



    class ConvergenceStudy : public SiloStudy
    {
    public:
      ConvergenceStudy(Parameters          &parameters,
                       const CommandLine   &command_line,
                       const ParameterFile &file,
                       const MPI_Comm       communicator)
        : SiloStudy(parameters,
                    command_line,
                    file,
                    communicator,
                    "convergence",
                    "refinement-")
      {
        const ConvergencePlan plan = plan_convergence(parameters, file);
        refinements                = plan.refinements;
        results.window_start       = plan.window_start;
        results.window_end         = plan.window_end;
      }

    private:
      void
      make_runs() override;

      bool
      has_results() const override
      {
        return !results.runs.empty();
      }

      std::string
      run_in_words() const override
      {
        return "Refinement " + short_text(refinements[results.runs.size()]);
      }

      std::string
      conclusion() const override
      {
        return to_text(results);
      }

      void
      write(const std::string &status, const std::string &message) override;

      /// One run, in its own directory.
      ConvergenceRun
      run_at(const double refinement);

      /// What a run has come to, the same on each rank. Collective.
      ConvergenceRun
      judge(const RunResult &result, const double refinement) const;

      /// From the last run, for those from this one on: proportional to the
      /// cube of the refinement, as particles and steps are.
      double
      estimated_seconds(const unsigned int first) const;

      /// Leave out what takes too long, and say how long the rest takes.
      void
      plan_rest();

      std::vector<double> refinements;
      ConvergenceResults  results;
    };



    ConvergenceRun
    ConvergenceStudy::judge(const RunResult &result,
                            const double     refinement) const
    {
      const Summary              &summary = result.summary;
      const auto                 &seconds = summary.seconds;
      const std::array<double, 4> values  = shared(std::array<double, 4>{
         {seconds.set_up + seconds.static_stage + seconds.particle_loop +
            seconds.output,
          result.discharge.mean(results.window_start, results.window_end),
          summary.flow.plateau,
         std::isnan(summary.flow.discharge_time) ? 0. : 1.}});
      return {summary.resolution,
              refinement,
              summary.n_cells,
              summary.totals.particle_steps,
              values[0],
              values[1],
              values[2],
              values[3] > 0.};
    }



    ConvergenceRun
    ConvergenceStudy::run_at(const double refinement)
    {
      set_parameter("Scene", "Refinement", refinement);
      const std::string which = short_text(refinement);
      log.stream() << run_in_words() << ": cells "
                   << to_text(parameters.scene.resolution()) << "; in "
                   << directory << '/' << subdirectory(which) << std::endl;
      return judge(run_in(which, file.warnings(dealii::ParameterAcceptor::prm)),
                   refinement);
    }



    double
    ConvergenceStudy::estimated_seconds(const unsigned int first) const
    {
      const ConvergenceRun &last    = results.runs.back();
      double                seconds = 0.;
      for (unsigned int i = first; i < refinements.size(); ++i)
        seconds += last.seconds * std::pow(refinements[i] / last.refinement, 3);
      return seconds;
    }



    void
    ConvergenceStudy::plan_rest()
    {
      const unsigned int n_done = results.runs.size();
      while (refinements.size() > std::max(fewest_convergence_runs, n_done) &&
             estimated_seconds(n_done) > longest_study)
        {
          log.stream() << "Refinement " << short_text(refinements.back())
                       << " is left out: with it the study would take about "
                       << duration_to_text(estimated_seconds(n_done))
                       << std::endl;
          refinements.pop_back();
        }
      if (n_done < refinements.size())
        log.stream() << "  about "
                     << duration_to_text(estimated_seconds(n_done)) << " left, "
                     << refinements.size() - n_done << " of "
                     << refinements.size() << " meshes" << std::endl;
    }



    void
    ConvergenceStudy::write(const std::string &status,
                            const std::string &message)
    {
      results.status  = status;
      results.message = message;
      Sandglass::write(results, directory);
    }



    void
    ConvergenceStudy::make_runs()
    {
      log.stream() << "Flow rate from " << short_text(results.window_start)
                   << " to " << short_text(results.window_end) << " s on "
                   << refinements.size() << " meshes" << std::endl;
      // plan_rest() shortens the list.
      for (unsigned int i = 0; i < refinements.size(); ++i)
        {
          results.runs.push_back(run_at(refinements[i]));
          log.stream() << "  " << short_text(results.runs.back().seconds)
                       << " s, " << std::setprecision(4)
                       << results.flow_rates().back() << " kg/s" << std::endl;
          write_results();
          plan_rest();
        }
    }
  } // namespace



  void
  study_convergence(Parameters          &parameters,
                    const CommandLine   &command_line,
                    const ParameterFile &file,
                    const MPI_Comm       communicator)
  {
    ConvergenceStudy(parameters, command_line, file, communicator).perform();
  }
} // namespace Sandglass
