#include <sandglass/base/parameter_entries.h>
#include <sandglass/flow/updated_lagrangian/static_stage_parameters.h>

namespace Sandglass
{
  StaticStageParameters::StaticStageParameters()
    : ParameterAcceptor("Static stage")
  {
    using Bounds = BoundedNumber;

    add_flag(*this,
             "Enabled",
             is_enabled,
             "Find the state at rest first; otherwise the material starts "
             "without stress.");
    add_flag(*this,
             "Displace particles",
             displaces_particles,
             "Start the particles where the load has moved them (paper), or at "
             "their places in the undeformed grid, whose cells they then fill "
             "evenly.");
    add_flag(*this,
             "Settle particles",
             settles_particles,
             "In a closed silo whose walls are at rest, let the particles find "
             "their own place of rest before the flow: the state of the "
             "elements is not quite one of particles and would ring for some "
             "seconds.");
    add_integer(*this,
                "Load steps",
                n_load_steps,
                1,
                10000,
                "Equal parts in which gravity is applied.");
    add_number(*this,
               "Relative residual",
               relative_residual,
               Bounds::between(0., 1.),
               "1",
               "Newton stops when the out-of-balance force is below this share "
               "of the weight.");
    add_integer(*this,
                "Maximum iterations",
                maximum_iterations,
                1,
                1000,
                "Newton iterations after which dynamic relaxation takes over; "
                "earlier if the residual doesn't fall any more.");
    add_number(*this,
               "Relaxed residual",
               relaxed_residual,
               Bounds::between(0., 1.),
               "1",
               "Where Newton finds no way, dynamic relaxation stops when the "
               "out-of-balance force is below this share of the weight.");
    add_integer(*this,
                "Maximum relaxation steps",
                maximum_relaxation_steps,
                0,
                100000000,
                "Steps of dynamic relaxation after which a load step is cut in "
                "half.");
    add_number(*this,
               "Smallest load step",
               smallest_load_step,
               Bounds::between(0., 1.),
               "1",
               "Share of gravity below which a load step is not cut further: "
               "the run stops.");
    add_integer(
      *this,
      "Direct solver up to",
      most_direct_unknowns,
      0,
      100000000,
      "Number of unknowns, two at each node of the filled mesh, up to "
      "which Newton's linear equations are solved by factors; in three "
      "dimensions, where factors fill up sooner, an eighth of it. Beyond "
      "it they are by iterations with multigrid, which take less time "
      "and memory for many unknowns, and which ranks share.");
  }
} // namespace Sandglass
