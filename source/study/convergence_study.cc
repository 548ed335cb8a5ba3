#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/base/parameter_entries.h>
#include <sandglass/output/log.h>
#include <sandglass/output/output_directory.h>
#include <sandglass/output/progress.h>
#include <sandglass/study/convergence_plan.h>
#include <sandglass/study/convergence_results.h>
#include <sandglass/study/convergence_study.h>
#include <sandglass/study/silo_study.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    /// A study that would take longer leaves its finest meshes out; wall time
    /// in s.
    constexpr double longest_study = 4. * 3600.;



    class ConvergenceStudy
    {
    public:
      /// Read the input; nothing is written yet.
      ConvergenceStudy(Parameters          &parameters,
                       const CommandLine   &command_line,
                       const ParameterFile &file,
                       const MPI_Comm       communicator)
        : parameters(parameters)
        , command_line(command_line)
        , file(file)
        , communicator(communicator)
        , directory(parameters.output.directory)
        , log(communicator,
              command_line.is_quiet ? Log::Screen::nothing :
                                      Log::Screen::everything)
      {
        const ConvergencePlan plan = plan_convergence(parameters, file);
        refinements                = plan.refinements;
        results.window_start       = plan.window_start;
        results.window_end         = plan.window_end;
      }

      void
      perform();

    private:
      /// One run, in its own directory.
      ConvergenceRun
      run_at(const double refinement, const std::vector<std::string> &warnings);

      /// What a run has come to, the same on each rank. Collective.
      ConvergenceRun
      shared(const RunResult &result, const double refinement) const;

      /// From the last run, for those from this one on: proportional to the
      /// cube of the refinement, as particles and steps are.
      double
      estimated_seconds(const unsigned int first) const;

      /// Leave out what takes too long, and say how long the rest takes.
      void
      plan_rest();

      /// Write results so far, and the log beside them. Collective.
      void
      write_results(const std::string &status, const std::string &message);

      /// Keep the results before the run that has just failed, and throw
      /// RunError that names it. Collective.
      [[noreturn]] void
      fail(const std::string &what);

      Parameters          &parameters;
      const CommandLine   &command_line;
      const ParameterFile &file;
      const MPI_Comm       communicator;
      const std::string    directory;
      Log                  log;
      std::vector<double>  refinements;
      ConvergenceResults   results;
      bool                 has_log_file = false;
    };



    ConvergenceRun
    ConvergenceStudy::shared(const RunResult &result,
                             const double     refinement) const
    {
      const Summary        &summary = result.summary;
      const auto           &seconds = summary.seconds;
      std::array<double, 4> values  = {
         {seconds.set_up + seconds.static_stage + seconds.particle_loop +
            seconds.output,
          result.discharge.mean(results.window_start, results.window_end),
          summary.flow.plateau,
         std::isnan(summary.flow.discharge_time) ? 0. : 1.}};
      if (Utilities::MPI::n_mpi_processes(communicator) > 1)
        values = Utilities::MPI::broadcast(communicator, values);
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
    ConvergenceStudy::run_at(const double                    refinement,
                             const std::vector<std::string> &warnings)
    {
      set_parameter("Scene", "Refinement", refinement);
      const std::string own =
        directory + "/refinement-" + short_text(refinement);
      log.stream() << "Refinement " << short_text(refinement) << ": cells "
                   << to_text(parameters.scene.resolution()) << "; in " << own
                   << std::endl;
      return shared(
        run_variant(parameters, command_line, own, warnings, communicator),
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
    ConvergenceStudy::write_results(const std::string &status,
                                    const std::string &message)
    {
      results.status  = status;
      results.message = message;
      do_and_share_errors(communicator, [this]() {
        if (Utilities::MPI::this_mpi_process(communicator) != 0)
          return;
        // The first run has made the directory.
        if (!has_log_file)
          log.open_file(directory + "/sandglass.log", false);
        has_log_file = true;
        write(results, directory);
      });
    }



    void
    ConvergenceStudy::fail(const std::string &what)
    {
      const std::string message = "Refinement " +
                                  short_text(refinements[results.runs.size()]) +
                                  ": " + what;
      write_results("failed", message);
      log.record_error(message);
      throw RunError(message);
    }



    void
    ConvergenceStudy::perform()
    {
      log.stream() << "Flow rate from " << short_text(results.window_start)
                   << " to " << short_text(results.window_end) << " s on "
                   << refinements.size() << " meshes" << std::endl;
      try
        {
          // plan_rest() shortens the list.
          for (unsigned int i = 0; i < refinements.size(); ++i)
            {
              results.runs.push_back(run_at(refinements[i], file.warnings()));
              log.stream() << "  " << short_text(results.runs.back().seconds)
                           << " s, " << std::setprecision(4)
                           << results.flow_rates().back() << " kg/s"
                           << std::endl;
              write_results("running", "");
              plan_rest();
            }
        }
      catch (const RunError &error)
        {
          fail(error.what());
        }
      catch (const InputError &error)
        {
          // Only the first run has written nothing yet.
          if (results.runs.empty())
            throw;
          fail(error.what());
        }
      write_results("finished", "");
      log.stream() << to_text(results) << "Results are in " << directory
                   << std::endl;
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
