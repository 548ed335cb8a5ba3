#ifndef sandglass_tests_rest_h
#define sandglass_tests_rest_h

#include <sandglass/flow/updated_lagrangian/static_stage.h>
#include <sandglass/run/static_to_particles.h>

#include <sstream>

#include "stage_fixture.h"

/**
 * Bring a started fixture's particles to rest by the static stage with its
 * default parameters, as a run does. Throws where it doesn't converge.
 *
 * @return the static stage's result.
 */
inline Sandglass::StaticState<2>
start_from_rest(const StageFixture &fixture)
{
  Sandglass::StaticStageParameters parameters;
  std::ostringstream               log_text;
  dealii::ConditionalOStream       log(log_text);
  Sandglass::StaticStage<2>        static_stage(
    *fixture.scene, fixture.material, fixture.walls, parameters, log);
  const Sandglass::StaticState<2> state = static_stage.run();
  Sandglass::carry_to_particles(state,
                                *fixture.scene,
                                *fixture.stage,
                                parameters.displaces_particles);
  return state;
}

#endif
