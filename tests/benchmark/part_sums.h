#ifndef sandglass_tests_benchmark_part_sums_h
#define sandglass_tests_benchmark_part_sums_h

#include <sandglass/flow/particle_in_cell/step_part.h>

#include <array>
#include <functional>

/// Adds up for each part of a step by how much a count grows, such as time.
class PartSums : public Sandglass::StepWatcher
{
public:
  using Part = Sandglass::StepPart;

  explicit PartSums(std::function<double()> count)
    : count(std::move(count))
  {}

  void
  begin(const Part part) override
  {
    // What the count itself takes belongs to no part.
    const double now = count();
    if (current != Part::done)
      sums[static_cast<unsigned int>(current)] += now - at_begin;
    current  = part;
    at_begin = count();
  }

  std::array<double, Sandglass::step_part_names.size()> sums{};

private:
  std::function<double()> count;
  Part                    current  = Part::done;
  double                  at_begin = 0.;
};

#endif
