#include <sandglass/base/exceptions.h>
#include <sandglass/scene/gate_parameters.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    constexpr unsigned int most_numbers = 200;
  }



  GateParameters::GateParameters()
    : ParameterAcceptor("Gates")
  {
    add_named_numbers(
      *this,
      "Openings",
      openings,
      NamedNumbersPattern(BoundedNumber::at_least(0.), 2, most_numbers),
      "s, %",
      "When outlets are open, and how far: by the outlet's name, times and the "
      "share of its width that is open then, by turns, linear in between; for "
      "example \"outlet: 0.5 0 1 100 4 100 4.2 30\" opens it within half a "
      "second and closes it to 30 % at 4 s. With several outlets their names "
      "are outlet_1, outlet_2, ... from left to right. An outlet without a name "
      "here is open. Until a gate opens, the material is at rest on it; it "
      "opens from one edge of the mesh to the next. For Flow/Method = "
      "particle-in-cell.");
    add_selection<OpensFrom>(*this,
                             "Opens from",
                             opens_from,
                             {{"middle", OpensFrom::middle},
                              {"left", OpensFrom::left},
                              {"right", OpensFrom::right}},
                             "Where a gate opens first: in its middle, as two "
                             "halves do that part, or at its left or right "
                             "end, as one does that slides off to the other "
                             "side (Scene/Symmetry = false only).");
  }



  double
  GateParameters::open_share(const std::string &outlet, const double time) const
  {
    const auto gate = openings.find(outlet);
    if (gate == openings.end())
      return 1.;
    const std::vector<double> &numbers = gate->second;
    if (time <= numbers[0])
      return numbers[1] / 100.;
    for (unsigned int i = 2; i < numbers.size(); i += 2)
      if (time < numbers[i])
        return (numbers[i - 1] + (numbers[i + 1] - numbers[i - 1]) *
                                   (time - numbers[i - 2]) /
                                   (numbers[i] - numbers[i - 2])) /
               100.;
    return numbers.back() / 100.;
  }



  void
  GateParameters::check() const
  {
    for (const auto &gate : openings)
      {
        const std::vector<double> &numbers = gate.second;
        const auto refuse = [&gate](const std::string &allowed) {
          throw InputError("Gates", "Openings", to_text(gate), allowed);
        };
        if (numbers.size() % 2 != 0)
          refuse("allowed are pairs of a time and a share");
        for (unsigned int i = 0; i < numbers.size(); i += 2)
          {
            if (numbers[i + 1] > 100.)
              refuse("allowed are shares between 0 and 100 %");
            if (i > 0 && numbers[i] < numbers[i - 2])
              refuse("allowed are times that do not fall");
          }
      }
  }
} // namespace Sandglass
