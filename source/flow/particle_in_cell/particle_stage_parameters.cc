#include <deal.II/base/utilities.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/base/parameter_entries.h>
#include <sandglass/flow/particle_in_cell/particle_stage_parameters.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  ParticleStageParameters::ParticleStageParameters()
    : ParameterAcceptor("Particle stage")
  {
    using Bounds = BoundedNumber;

    add_number(*this,
               "End time",
               end_time,
               Bounds::at_least(0.),
               "s",
               "Simulated time at which the run ends.");
    add_text(*this,
             "Time step",
             time_step_text,
             Patterns::Anything(),
             "`auto` for a share of the critical step, a number, or a table "
             "`0: 2.5e-4, 2: 1.25e-4` of times from which steps hold. "
             "Units: s.");
    add_number(*this,
               "Time step safety",
               time_step_safety,
               Bounds::between(0., 2.),
               "1",
               "Share of the critical step that `auto` takes.");
    add_integer(*this,
                "Time step interval",
                time_step_interval,
                1,
                100000,
                "Steps after which `auto` finds the critical step anew; with a "
                "consistent mass share alpha (1 - alpha)^3 times as many.");
    add_number(*this,
               "Consistent mass share",
               consistent_mass_share,
               Bounds::at_least_below(0., 1.),
               "1",
               "Share alpha of the consistent mass matrix M in alpha M + (1 - "
               "alpha) M_I; 0 takes the lumped one, M_I, which needs no "
               "solver.");
    add_selection<StressIntegration>(
      *this,
      "Stress integration",
      stress_integration,
      {{"start of step", StressIntegration::start_of_step},
       {"middle of step", StressIntegration::middle_of_step}},
      "Configuration in which a step's strain and rotation are taken: its start "
      "(paper), or its middle with an exact rotation (Hughes and Winget 1980), "
      "which keeps the stress in a rigid rotation.");
    add_selection<VolumetricStrain>(
      *this,
      "Volumetric strain",
      volumetric_strain,
      {{"element", VolumetricStrain::element},
       {"averaged", VolumetricStrain::averaged}},
      "Change of volume of a stressed particle: that of its cell (paper), or "
      "the average over the cells around it, without which linear cells lock "
      "under plastic flow that keeps the volume.");
    add_selection<ForceIntegration>(
      *this,
      "Force integration",
      force_integration,
      {{"particles", ForceIntegration::particles},
       {"cell", ForceIntegration::cell}},
      "Volume over which the stress in a cell is integrated to the nodes' "
      "forces: the particles' (paper), which changes whenever one crosses an "
      "edge and so shakes the material and lowers its friction; or the cell's "
      "own where particles fill it.");
    add_selection<DensityUpdate>(
      *this,
      "Density update",
      density_update,
      {{"paper", DensityUpdate::paper},
       {"separation", DensityUpdate::separation}},
      "How a particle's density follows the flow: divided by the volume's "
      "growth as in the paper, which drifts without bound in separated "
      "material; or the same, with stress only while the particle is at least "
      "as dense as Loosest density says.");
    add_number(*this,
               "Loosest density",
               loosest_density,
               Bounds::within(0.5, 1.),
               "1",
               "With the density update separation: density over that of the "
               "unstressed material, beyond its elastic expansion, below which "
               "a particle carries no stress. At 1 it separates at once. "
               "Hypoplastic laws and Lade's have limits of their own.");
    add_selection<SplitParticles>(
      *this,
      "Split particles",
      split_particles,
      {{"never", SplitParticles::never},
       {"where needed", SplitParticles::where_needed}},
      "Whether particles that are too large for the cell that they have come "
      "to are halved, since small cells otherwise hold few particles or none: "
      "never (paper); or where needed, which is in meshes whose cells' volumes "
      "differ by more than a factor of six, as they do in graded and in "
      "axisymmetric ones.");
    add_selection<RelieveOverfullCells>(
      *this,
      "Relieve overfull cells",
      relieve_overfull_cells,
      {{"auto", RelieveOverfullCells::automatic},
       {"never", RelieveOverfullCells::never},
       {"where fed", RelieveOverfullCells::where_fed},
       {"always", RelieveOverfullCells::always}},
      "Whether particles are compacted where they fill their cells too much, "
      "so that pressure drives out what has gathered there: never (paper); "
      "where fed, which is in silos that are kept full (Feed/Kind = level) "
      "while an outlet is open, since their slow corners fill up over many "
      "contents; auto, which is also in hexahedra whose volumes differ by more "
      "than a factor of twelve while an outlet is open, since the flow below a "
      "crater fills up in them; or always, with which overfull material without an outlet "
      "doesn't come to rest. It takes the averaged Volumetric strain, and a law "
      "that follows it (all but Lade's).");
    add_automatic_number(
      *this,
      "PIC share",
      pic_share,
      Bounds::at_least_below(0., 1.),
      "1",
      "Share in each step that a particle's velocity takes of the velocity with "
      "which it moves (PIC) instead of its own (paper: 0). Without it light "
      "particles among heavy ones gather velocities that their nodes don't "
      "see, and are thrown out. auto is 0.003 in hexahedra whose volumes differ "
      "by more than a factor of twelve, and else 0; in two dimensions no other "
      "is allowed.");
    add_selection<OnLostParticle>(
      *this,
      "On lost particle",
      on_lost_particle,
      {{"hold", OnLostParticle::hold},
       {"stop", OnLostParticle::stop},
       {"remove", OnLostParticle::remove}},
      "What to do with a particle that leaves the grid other than through the "
      "fall region: hold it at the grid's top, without its velocity out of it, "
      "and stop the run anywhere else; stop the run; or remove and count it.");
    add_number(*this,
               "Largest speed",
               largest_speed,
               Bounds::greater_than(0.),
               "1",
               "The run stops when a particle is faster than this many times "
               "the free fall from the material's top to the grid's bottom.");
  }



  unsigned int
  ParticleStageParameters::automatic_step_interval() const
  {
    // A node that is losing its mass lowers the critical step; the less of the
    // mass is lumped, the faster.
    const double lumped_share = 1. - consistent_mass_share;
    return std::max(1u,
                    static_cast<unsigned int>(time_step_interval *
                                              std::pow(lumped_share, 3)));
  }



  namespace
  {
    /// Whether `text` is one positive number.
    bool
    read_positive(const std::string &text, double &value)
    {
      std::istringstream stream(text);
      return (stream >> value) && (stream >> std::ws).eof() && value > 0.;
    }



    /// One line `start: step` of the table.
    bool
    read_line(const std::string &text, std::pair<double, double> &line)
    {
      const auto colon = text.find(':');
      if (colon == std::string::npos)
        return false;
      std::istringstream start(text.substr(0, colon));
      return (start >> line.first) && (start >> std::ws).eof() &&
             line.first >= 0. &&
             read_positive(text.substr(colon + 1), line.second);
    }
  } // namespace



  void
  ParticleStageParameters::check()
  {
    const auto refuse = [this]() {
      throw InputError("Particle stage",
                       "Time step",
                       time_step_text,
                       "allowed is auto, a number of seconds greater than 0, "
                       "or a table like '0: 2.5e-4, 2: 1.25e-4' that starts "
                       "at 0 with growing times");
    };

    time_steps.clear();
    has_automatic_time_step = time_step_text == "auto";
    if (has_automatic_time_step)
      return;

    double constant_step;
    if (read_positive(time_step_text, constant_step))
      {
        time_steps = {{0., constant_step}};
        return;
      }

    for (const auto &text : Utilities::split_string_list(time_step_text, ','))
      {
        std::pair<double, double> line;
        if (!read_line(text, line) ||
            (time_steps.empty() ? line.first != 0. :
                                  line.first <= time_steps.back().first))
          refuse();
        time_steps.push_back(line);
      }
    if (time_steps.empty())
      refuse();
  }
} // namespace Sandglass
