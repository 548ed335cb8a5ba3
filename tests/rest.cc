#include "rest.h"

#include <sandglass/run/static_to_particles.h>

#include <sstream>

using namespace Sandglass;

StaticState<2>
start_from_rest(const StageFixture &fixture)
{
  StaticStageParameters      parameters;
  std::ostringstream         log_text;
  dealii::ConditionalOStream log(log_text);
  StaticStage<2>             static_stage(
    *fixture.scene, fixture.material, fixture.walls, parameters, log);
  const StaticState<2> state = static_stage.run();
  carry_to_particles(state,
                     *fixture.scene,
                     *fixture.stage,
                     parameters.displaces_particles);
  return state;
}
