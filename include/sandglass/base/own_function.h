#ifndef sandglass_base_own_function_h
#define sandglass_base_own_function_h

/**
 * For a function that goes through all cells in each step, or is called for
 * each node at a wall: compiled by itself, with all that it calls inlined. Left
 * to itself GCC inlines a loop over cells into the step, and then finds that
 * too large to inline what the loop calls.
 */
#define SANDGLASS_OWN_FUNCTION __attribute__((flatten, noinline))

#endif
