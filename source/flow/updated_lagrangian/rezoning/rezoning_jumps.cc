#include <sandglass/flow/updated_lagrangian/rezoning/rezoning_jumps.h>

#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// Of material at rest there is no relative jump of energy.
    double
    relative_jump(const double before, const double after)
    {
      return before == after ? 0. : (after - before) / before;
    }
  } // namespace



  std::string
  RezoningJumps::description() const
  {
    std::ostringstream text;
    text.precision(3);
    text << "re-zoned " << n_bodies << (n_bodies == 1 ? " body" : " bodies")
         << " into " << n_cells << " elements, " << n_nodes
         << " nodes; jumps: area " << relative_jump(before.area, after.area)
         << ", mass " << relative_jump(before.mass, mapped.mass)
         << " (restored to " << relative_jump(before.mass, after.mass)
         << "), velocity (" << (mapped.momentum - before.momentum) / before.mass
         << ") m/s (restored to ("
         << (after.momentum - before.momentum) / before.mass
         << ") m/s), kinetic energy "
         << relative_jump(before.kinetic_energy, after.kinetic_energy) << "; "
         << n_limited << " points limited, " << n_projected
         << " nodes projected by at most " << farthest << " m, "
         << n_straightened << " edges straightened";
    return text.str();
  }
} // namespace Sandglass
