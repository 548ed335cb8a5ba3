#ifndef sandglass_tests_heap_h
#define sandglass_tests_heap_h

#include "stage_fixture.h"

/**
 * A flat heap on a plane floor 4 m long. The heap's sides are less steep than
 * its internal friction allows: a block of material without cohesion could not
 * keep its shape.
 */
class Heap
{
public:
  using Point = dealii::Point<2>;

  Heap()
  {
    fixture.material.internal_friction_angle = 60.;
    fixture.parameters.end_time              = 10.;
    rectangle.left                           = Sandglass::BoundaryRole::wall;
    rectangle.upper                          = Point(4., 0.4);
    rectangle.n_x                            = 80;
    rectangle.n_y                            = 8;
    rectangle.is_filled                      = [](const Point &center) {
      return center[1] < 0.15 && center[0] - center[1] / 0.3 > 0.5 &&
             center[0] + center[1] / 0.3 < 2.;
    };
  }

  /// Mean velocity along the floor, in m/s.
  double
  velocity() const
  {
    double mass = 0., momentum = 0.;
    fixture.for_each_particle([&](auto, auto, auto state) {
      mass += state[StageLayout::mass];
      momentum += state[StageLayout::mass] * state[StageLayout::velocity];
    });
    return momentum / mass;
  }

  /// In J.
  double
  potential_energy() const
  {
    double energy = 0.;
    fixture.for_each_particle([&](auto, const auto &position, auto state) {
      energy -= state[StageLayout::mass] * (fixture.gravity * position);
    });
    return energy;
  }

  double
  time() const
  {
    return fixture.stage->view().clock().time;
  }

  void
  run_until(const double end)
  {
    while (time() < end)
      fixture.stage->step();
  }

  double
  velocity_at(const double end)
  {
    run_until(end);
    return velocity();
  }

  StageFixture fixture;
  Rectangle    rectangle; ///< of the grid
};

#endif
