#ifndef sandglass_scene_gate_parameters_h
#define sandglass_scene_gate_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <sandglass/base/parameter_entries.h>

#include <string>

namespace Sandglass
{
  /// Section `Gates`: when outlets are open, and how far.
  class GateParameters : public dealii::ParameterAcceptor
  {
  public:
    GateParameters();

    /// Where a gate opens first.
    enum class OpensFrom
    {
      middle, ///< two halves part, or a round one widens
      left,   ///< it slides off to the right
      right   ///< it slides off to the left
    };

    /// By the outlet's name: a time in s and the share that is open from then
    /// on in per cent, by turns, linear in between.
    NamedNumbers openings;
    OpensFrom    opens_from = OpensFrom::middle;

    /// Whether there are gates.
    bool
    are_on() const
    {
      return !openings.empty();
    }

    /// How much of an outlet is open at a time in s, between 0 and 1; all of it
    /// without a gate.
    double
    open_share(const std::string &outlet, const double time) const;

    /// Throws InputError where an opening isn't one.
    void
    check() const;
  };
} // namespace Sandglass

#endif
