#include <sandglass/base/exceptions.h>
#include <sandglass/base/parameter_entries.h>
#include <sandglass/output/output_parameters.h>

namespace Sandglass
{
  OutputParameters::OutputParameters()
    : ParameterAcceptor("Output")
  {
    using Bounds = BoundedNumber;

    add_text(
      *this,
      "Directory",
      directory,
      dealii::Patterns::DirectoryName(),
      "Where the results go; made if it doesn't exist. A run that starts "
      "removes those of older runs there.");
    add_number(*this,
               "Interval",
               interval,
               Bounds::greater_than(0.),
               "s",
               "Simulated time between outputs of particles, grid and walls. "
               "Wall tractions are means over it.");
    add_number(*this,
               "History interval",
               history_interval,
               Bounds::greater_than(0.),
               "s",
               "Simulated time between rows of history.csv and flow_rate.csv.");
    add_number(*this,
               "Flow rate window",
               flow_rate_window,
               Bounds::greater_than(0.),
               "s",
               "The mass flow rate is the mean over this simulated time, or "
               "over the history interval if that is longer.");
    add_flag(*this,
             "Particles",
             writes_particles,
             "Write particles.pvd and its files.");
    add_flag(*this, "Grid", writes_grid, "Write grid.pvd and its files.");
    add_flag(*this,
             "Walls",
             writes_walls,
             "Write wall_traction.csv, walls.pvd and its files.");
    add_number(*this,
               "Janssen lateral pressure ratio",
               lateral_pressure_ratio,
               Bounds::at_least(0.),
               "1",
               "Ratio K of horizontal to vertical pressure in Janssen's "
               "formula; 0 takes K = 1.1 (1 - sin(phi)) of EN 1991-4, with the "
               "internal friction angle phi.");
    add_number(*this,
               "Patch load factor",
               patch_load_factor,
               Bounds::at_least(0.),
               "1",
               "The solid's reference factor C_op for the patch loads of EN "
               "1991-4, from its Table E.1: 0.5 for wheat, 0.9 for maize, 1 "
               "for solids that the table doesn't have.");
    add_flag(*this,
             "Residence",
             writes_residence,
             "Write residence.csv and residence.vtu: when material has left "
             "the silo, by its first place.");
    add_named_numbers(
      *this,
      "Gauges",
      gauges,
      NamedNumbersPattern(Bounds::any(), 2, 3),
      "m",
      "Points by name, x and y (and z in three dimensions), for example "
      "\"foot: 0.8 0.1, middle: 0 0.6\". With each row of history.csv gauges.csv "
      "gets the tractions there, where the point is on a wall, and the state "
      "of the material around it.");
    add_number(
      *this,
      "Stagnant displacement",
      stagnant_displacement,
      Bounds::at_least(0.),
      "outlet widths",
      "Material in the silo that is at most this far from where it was "
      "before the static stage counts as stagnant in history.csv; 0 "
      "leaves that column out.");
    add_number(*this,
               "Progress interval",
               progress_interval,
               Bounds::at_least(0.),
               "s (wall time)",
               "Time between progress lines; 0 writes none.");
    add_number(*this,
               "Checkpoint interval",
               checkpoint_interval,
               Bounds::at_least(0.),
               "s",
               "Simulated time between checkpoints, from which --restart goes "
               "on; 0 writes none but when a signal stops the run.");
  }



  void
  OutputParameters::check() const
  {
    if (directory.empty())
      throw InputError("Output",
                       "Directory",
                       directory,
                       "allowed is the name of a directory");
  }
} // namespace Sandglass
