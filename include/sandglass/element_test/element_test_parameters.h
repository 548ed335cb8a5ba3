#ifndef sandglass_element_test_element_test_parameters_h
#define sandglass_element_test_element_test_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <sandglass/element_test/element_test_settings.h>

namespace Sandglass
{
  /// Section `Element test`: the law alone, at one material point.
  class ElementTestParameters : public dealii::ParameterAcceptor,
                                public ElementTestSettings
  {
  public:
    ElementTestParameters();

    /// What can be said without a law; throws InputError.
    void
    check() const;
  };
} // namespace Sandglass

#endif
