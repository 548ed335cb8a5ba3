#ifndef sandglass_flow_flow_h
#define sandglass_flow_flow_h

#include <sandglass/flow/flow_view.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <vector>

namespace Sandglass
{
  /**
   * A way to compute the material's motion, or how it comes to rest: what the
   * run needs of it, whatever method, kinematics and law.
   */
  class Flow : protected FlowView
  {
  public:
    /// To the next time, or load. Throws RunError. Collective.
    virtual void
    step() = 0;

    virtual bool
    is_finished() const = 0;

    /// The present state, for all output.
    const FlowView &
    view() const
    {
      return *this;
    }

    /// Write all that load() needs; complete on rank 0. Collective.
    virtual void
    save(boost::archive::binary_oarchive &archive) const = 0;

    /// Go on from what save() has written, on any number of ranks: a flow in
    /// time bit by bit on the same number with the same partition, the state at
    /// rest within Newton's tolerance. Each rank reads all of it.
    virtual void
    load(boost::archive::binary_iarchive &archive) = 0;

    /// What each cell of the scene costs in a step, as cell_work() in
    /// scene/partition.h tells it; 0 for other ranks' cells.
    virtual std::vector<double>
    cell_work() const = 0;
  };
} // namespace Sandglass

#endif
