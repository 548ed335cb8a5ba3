#ifndef sandglass_base_own_function_h
#define sandglass_base_own_function_h

/**
 * For a function that each step calls, for all nodes at walls or one of them:
 * compiled by itself, with all that it calls inlined.
 */
#define SANDGLASS_OWN_FUNCTION __attribute__((flatten, noinline))

#endif
