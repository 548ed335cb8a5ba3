#ifndef sandglass_tests_cleared_parameters_h
#define sandglass_tests_cleared_parameters_h

#include <deal.II/base/parameter_acceptor.h>

/// The parameter classes add themselves to a global list. As a member before
/// them it clears the list, so that each test can make its own.
struct ClearedParameters
{
  ClearedParameters()
  {
    dealii::ParameterAcceptor::clear();
  }
};

#endif
