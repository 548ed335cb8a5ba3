#include <sandglass/base/exceptions.h>
#include <sandglass/base/parameter_entries.h>
#include <sandglass/output/csv_file.h>
#include <sandglass/scene/automatic_mesh.h>
#include <sandglass/study/convergence_plan.h>
#include <sandglass/study/silo_study.h>

#include <algorithm>
#include <cmath>

namespace Sandglass
{
  namespace
  {
    /// Factors of refinement, about the root of two apart.
    constexpr double factors[] = {0.5, 0.7, 1., 1.4, 2.};
    /// Times in sqrt(D / g): flow has formed; a rate can be told; the end.
    constexpr double flow_has_formed = 3., earliest_end = 4., usual_end = 5.;
    /// Rows of the history in such a time, at least.
    constexpr double rows_per_time = 10.;



    void
    set_times(Parameters          &parameters,
              const ParameterFile &file,
              ConvergencePlan     &plan)
    {
      const double time =
        std::sqrt(2. * parameters.scene.outlet_half_width /
                  parameters.scene.gravity_vector<2>().norm());
      const double given_end = parameters.particle_stage.end_time;
      if (given_end < earliest_end * time)
        throw InputError("Particle stage",
                         "End time",
                         to_text(given_end),
                         "allowed is at least " +
                           short_text(earliest_end * time) +
                           " s with --study convergence, four times the root "
                           "of outlet width over gravity");
      plan.window_start = flow_has_formed * time;
      plan.window_end = file.is_on_command_line("Particle stage", "End time") ?
                          given_end :
                          std::min(given_end, usual_end * time);
      set_parameter("Particle stage", "End time", plan.window_end);
      set_parameter("Output",
                    "History interval",
                    std::min(parameters.output.history_interval,
                             time / rows_per_time));
    }



    std::vector<double>
    find_refinements(Parameters &parameters)
    {
      const double        given = parameters.scene.refinement;
      std::string         refused;
      std::vector<double> refinements;
      for (const double factor : factors)
        try
          {
            const double refinement = given * factor;
            if (refinement < smallest_refinement ||
                refinement > largest_refinement)
              continue;
            parameters.scene.refinement = refinement;
            parameters.scene.check();
            refinements.push_back(refinement);
          }
        catch (const InputError &error)
          {
            refused = error.what();
          }
      parameters.scene.refinement = given;
      if (refinements.size() < fewest_convergence_runs)
        throw InputError("Scene",
                         "Refinement",
                         to_text(given),
                         "--study convergence needs three meshes about this "
                         "one; " +
                           refused);
      return refinements;
    }
  } // namespace



  ConvergencePlan
  plan_convergence(Parameters &parameters, const ParameterFile &file)
  {
    parameters.fix_resolution();
    ConvergencePlan plan;
    set_times(parameters, file, plan);
    plan.refinements = find_refinements(parameters);
    return plan;
  }
} // namespace Sandglass
