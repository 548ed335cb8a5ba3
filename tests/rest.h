#ifndef sandglass_tests_rest_h
#define sandglass_tests_rest_h

#include <sandglass/flow/updated_lagrangian/static_stage.h>

#include "stage_fixture.h"

/**
 * Bring a started fixture's particles to rest by the static stage with its
 * default parameters, as a run does. Throws where it doesn't converge.
 *
 * @return the static stage's result.
 */
Sandglass::StaticState<2>
start_from_rest(const StageFixture &fixture);

#endif
