#ifndef sandglass_tests_random_engine_h
#define sandglass_tests_random_engine_h

#include <iostream>
#include <random>

/**
 * An engine for tests that draw random numbers: always the same numbers, and
 * the seed in the test's output.
 *
 * The engine's numbers are the same everywhere, those of the distributions in
 * <random> only with one standard library.
 */
inline std::mt19937
random_engine(const unsigned int seed = 1)
{
  std::cout << "random seed " << seed << std::endl;
  return std::mt19937(seed);
}

#endif
