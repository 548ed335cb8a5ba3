#ifndef sandglass_tests_benchmark_counted_parts_h
#define sandglass_tests_benchmark_counted_parts_h

#include <sandglass/flow/particle_in_cell/step_part.h>

#include <valgrind/callgrind.h>

/// Under callgrind, leaves a dump of the instructions of each part of a step,
/// with the part's name as its trigger.
class CountedParts : public Sandglass::StepWatcher
{
public:
  using Part = Sandglass::StepPart;

  CountedParts()
  {
    CALLGRIND_START_INSTRUMENTATION;
  }

  ~CountedParts() override
  {
    CALLGRIND_STOP_INSTRUMENTATION;
  }

  void
  begin(const Part part) override
  {
    if (current == Part::done)
      CALLGRIND_ZERO_STATS;
    else
      CALLGRIND_DUMP_STATS_AT(
        Sandglass::step_part_names[static_cast<unsigned int>(current)]);
    current = part;
  }

private:
  Part current = Part::done;
};

#endif
