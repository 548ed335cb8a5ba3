#include <deal.II/base/numbers.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/base/parameter_entries.h>
#include <sandglass/output/jenike.h>
#include <sandglass/study/free_rate.h>
#include <sandglass/study/silo_study.h>
#include <sandglass/study/smallest_outlet.h>
#include <sandglass/walls/boundary_role.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    /// Material that leaves with this share of rho sqrt(g) D^n flows.
    constexpr double flowing_share = 0.1;
    /// The narrowest outlet tried, over the scene's.
    constexpr double narrowest = 1. / 32.;
    /// Bisection ends when the bounds are this close.
    constexpr double close_enough = 1.05;
    /// Usual length of a run, in sqrt(D / g) of the scene's outlet.
    constexpr double usual_end = 5.;



    class SmallestOutletStudy : public SiloStudy
    {
    public:
      SmallestOutletStudy(Parameters          &parameters,
                          const CommandLine   &command_line,
                          const ParameterFile &file,
                          const MPI_Comm       communicator);

    private:
      void
      make_runs() override
      {
        find_bounds();
        bisect();
      }

      bool
      has_results() const override
      {
        return !results.trials.empty();
      }

      std::string
      run_in_words() const override
      {
        return "Outlet half width " +
               short_text(parameters.scene.outlet_half_width);
      }

      std::string
      conclusion() const override;

      void
      write(const std::string &status, const std::string &message) override;

      /// Try outlets until one flows and one does not; the results tell.
      void
      find_bounds();

      void
      bisect();

      /// Run the scene with this outlet.
      void
      attempt(const double half_width);

      /// Set the outlet, the hopper of the same slope, and what the program
      /// chooses for them.
      void
      set_outlet(const double half_width);

      /// The mean rate over the last third in kg/s, the same on each rank, and
      /// whether the material flows. Collective.
      OutletTrial
      judge(const RunResult &result, const double half_width) const;

      void
      set_jenike();

      const double first_half_width;
      /// Horizontal over vertical length of the hopper's wall.
      const double   hopper_slope;
      SmallestOutlet results;
      /// What the program chooses anew for each outlet, as the user gave it.
      std::vector<std::string> automatic_parameters;
    };



    SmallestOutletStudy::SmallestOutletStudy(Parameters          &parameters,
                                             const CommandLine   &command_line,
                                             const ParameterFile &file,
                                             const MPI_Comm       communicator)
      : SiloStudy(parameters,
                  command_line,
                  file,
                  communicator,
                  "smallest-outlet",
                  "outlet-half-width-")
      , first_half_width(parameters.scene.outlet_half_width)
      , hopper_slope(parameters.scene.hopper_height > 0. ?
                       (parameters.scene.half_width - first_half_width) /
                         parameters.scene.hopper_height :
                       0.)
    {
      const SceneParameters &scene = parameters.scene;
      if (scene.outlet_half_depth)
        throw InputError("Scene",
                         "Outlet half depth",
                         short_text(*scene.outlet_half_depth),
                         "allowed is auto with --study smallest-outlet");
      const double time =
        std::sqrt(2. * first_half_width / scene.gravity_vector<2>().norm());
      if (!file.is_on_command_line("Particle stage", "End time"))
        set_parameter("Particle stage",
                      "End time",
                      std::min(parameters.particle_stage.end_time,
                               usual_end * time));
      set_parameter("Output",
                    "History interval",
                    std::min(parameters.output.history_interval,
                             parameters.particle_stage.end_time / 60.));
      if (!scene.headroom)
        automatic_parameters.push_back("Headroom");
      if (!scene.outlet_element_size)
        automatic_parameters.push_back("Outlet element size");
      if (!scene.element_size)
        automatic_parameters.push_back("Element size");
      if (!scene.particles_per_cell)
        automatic_parameters.push_back("Particles per cell");
      set_jenike();
    }



    void
    SmallestOutletStudy::set_jenike()
    {
      const MaterialParameters &material = parameters.material;
      const double              phi      = friction_angle(material);
      const double wall_angle = radians(parameters.walls.friction_angle_of(
        std::string(name_of(BoundaryRole::hopper))));
      const Jenike jenike{has_slot(parameters.scene) ?
                            Formulation::plane_strain :
                            Formulation::axisymmetric,
                          phi,
                          wall_angle,
                          std::atan(hopper_slope)};
      const double weight_density =
        material.density * parameters.scene.gravity_vector<2>().norm();
      results.unconfined_strength =
        2. * material.cohesion * std::cos(phi) / (1. - std::sin(phi));
      results.flow_factor = jenike.flow_factor();
      results.arching_width =
        jenike.arching_width(results.unconfined_strength, weight_density);
      results.rathole_diameter =
        jenike.rathole_diameter(results.unconfined_strength, weight_density);
      results.mass_flow_limit = jenike.mass_flow_limit() * 180. / numbers::PI;
    }



    void
    SmallestOutletStudy::set_outlet(const double half_width)
    {
      set_parameter("Scene", "Outlet half width", half_width);
      if (hopper_slope > 0.)
        set_parameter("Scene",
                      "Hopper height",
                      (parameters.scene.half_width - half_width) /
                        hopper_slope);
      for (const std::string &name : automatic_parameters)
        set_parameter("Scene", name, std::string(automatic));
      parameters.check();
      parameters.fix_resolution();
    }



    OutletTrial
    SmallestOutletStudy::judge(const RunResult &result,
                               const double     half_width) const
    {
      const double                end    = parameters.particle_stage.end_time;
      const std::array<double, 2> values = shared(std::array<double, 2>{
        {result.discharge.mean(2. / 3. * end, end),
         std::isnan(result.summary.flow.discharge_time) ? 0. : 1.}});
      // A silo that has emptied has flowed, too.
      const double left = result.summary.totals.mass_in_silo;
      const bool   has_emptied =
        values[1] > 0. && left < 0.05 * result.summary.initial_mass;
      return {half_width,
              values[0],
              has_emptied ||
                values[0] >
                  flowing_share * free_rate(parameters.scene,
                                            parameters.material.density,
                                            2. * half_width)};
    }



    void
    SmallestOutletStudy::attempt(const double half_width)
    {
      set_outlet(half_width);
      const std::string which = short_text(half_width);
      log.stream() << run_in_words() << " m; in " << directory << '/'
                   << subdirectory(which) << std::endl;
      const std::vector<std::string> warnings =
        results.trials.empty() ? file.warnings(ParameterAcceptor::prm) :
                                 std::vector<std::string>();
      const OutletTrial trial = judge(run_in(which, warnings), half_width);
      results.trials.push_back(trial);
      log.stream() << "  " << (trial.flows ? "flows" : "stands") << ", "
                   << short_text(trial.flow_rate) << " kg/s" << std::endl;
      write_results();
    }



    void
    SmallestOutletStudy::find_bounds()
    {
      double half_width = first_half_width;
      attempt(half_width);
      const bool flows_at_first = results.trials.back().flows;
      while (results.trials.back().flows == flows_at_first)
        {
          half_width *= flows_at_first ? 0.7 : 1.4;
          if (half_width < narrowest * first_half_width ||
              half_width > 0.95 * parameters.scene.half_width)
            return;
          try
            {
              attempt(half_width);
            }
          catch (const InputError &error)
            {
              log.stream() << "No narrower or wider outlet: " << error.what()
                           << std::endl;
              return;
            }
        }
    }



    void
    SmallestOutletStudy::bisect()
    {
      while (results.smallest_flowing() >
             close_enough * results.largest_arrested())
        attempt(
          std::sqrt(results.smallest_flowing() * results.largest_arrested()));
    }



    void
    SmallestOutletStudy::write(const std::string &status,
                               const std::string &message)
    {
      results.status  = status;
      results.message = message;
      write_study(directory,
                  smallest_outlet_table,
                  results.trials,
                  smallest_outlet_summary_table,
                  results);
    }



    std::string
    SmallestOutletStudy::conclusion() const
    {
      const double smallest = results.smallest_flowing(),
                   largest  = results.largest_arrested();
      return (std::isnan(largest) ?
                "The material flows through every outlet tried" :
              std::isnan(smallest) ?
                "The material stands in every outlet tried" :
                "The material flows from a half width of " +
                  short_text(smallest) + " m, and stands at " +
                  short_text(largest) + " m") +
             "; Jenike's outlet has a width of " +
             short_text(results.arching_width) + " m. ";
    }
  } // namespace



  void
  study_smallest_outlet(Parameters          &parameters,
                        const CommandLine   &command_line,
                        const ParameterFile &file,
                        const MPI_Comm       communicator)
  {
    SmallestOutletStudy(parameters, command_line, file, communicator).perform();
  }
} // namespace Sandglass
