#include <sandglass/output/section_wall_tractions.h>

#include <cmath>

#include "physics/wall_balance.h"

using namespace Sandglass;

namespace
{
  using WallTractionsTest = BeginningFlow;
}



TEST_P(WallTractionsTest, OverTheWallsMakeUpTheForces)
{
  const FlowView        &view = fixture.stage->view();
  const OutputParameters output;
  WallTractions<2>       observer(output, *fixture.scene, fixture.material);
  observer.since_last(view.clock().time, view.wall_records());
  run(0.02);
  const auto tractions =
    observer.since_last(view.clock().time, view.wall_records());

  Tensor<1, 2> expected;
  double       largest = 0.;
  for (const MeanWallForce &force : fixture.take_mean_forces())
    {
      expected += force.force;
      largest += force.force.norm();
    }
  // The piecewise linear tractions' integral over the walls' lines.
  Tensor<1, 2> found;
  for (unsigned int i = 0; i + 1 < tractions.size(); ++i)
    {
      const WallTraction &a = tractions[i], &b = tractions[i + 1];
      if (a.record.wall != b.record.wall || a.place.line != b.place.line)
        continue;
      const double length = b.place.arc_length - a.place.arc_length;
      EXPECT_NEAR(length, a.record.position.distance(b.record.position), 1e-12);
      for (const WallTraction *end : {&a, &b})
        {
          // half of the edge, of the ring at a third of it from the end
          const double other =
            end == &a ? b.record.position[0] : a.record.position[0];
          const double area = fixture.formulation == Formulation::plane_strain ?
                                length / 2. :
                                length * numbers::PI *
                                  (2. * end->record.position[0] + other) / 3.;
          for (unsigned int d = 0; d < 2; ++d)
            found[d] += area * end->on_material[d];
        }
    }
  EXPECT_NEAR((found - expected).norm() / largest, 0., 1e-12);
}

SANDGLASS_FOR_BEGINNING_FLOWS(WallTractionsTest);
