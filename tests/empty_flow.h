#ifndef sandglass_tests_empty_flow_h
#define sandglass_tests_empty_flow_h

#include <sandglass/flow/flow.h>

/// A flow without material that does nothing, for tests to give it something.
class EmptyFlow : public Sandglass::Flow
{
public:
  void
  step() override
  {}

  bool
  is_finished() const override
  {
    return false;
  }

  void
  save(boost::archive::binary_oarchive &) const override
  {}

  void
  load(boost::archive::binary_iarchive &) override
  {}

  std::vector<double>
  cell_work() const override
  {
    return {};
  }

protected:
  const Sandglass::Clock &
  clock() const override
  {
    return time;
  }

  Sandglass::FlowTotals
  totals() const override
  {
    return {};
  }

  double
  critical_time_step(const bool) const override
  {
    return 0.;
  }

  Sandglass::WallArea
  wall_area() const override
  {
    return {};
  }

  Sandglass::WallRecords
  wall_records() const override
  {
    return {};
  }

  std::vector<Sandglass::StateVariable>
  state_variables() const override
  {
    return {};
  }

  unsigned int
  n_particles() const override
  {
    return 0;
  }

  void
  for_each_particle(const std::function<void(const Sandglass::ParticleRecord &)>
                      &) const override
  {}

  Sandglass::GridRecords
  grid() const override
  {
    return {};
  }

  Sandglass::Clock time;
};

#endif
