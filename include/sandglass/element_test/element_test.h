#ifndef sandglass_element_test_element_test_h
#define sandglass_element_test_element_test_h

#include <sandglass/base/exceptions.h>
#include <sandglass/element_test/element_test_row.h>
#include <sandglass/element_test/mixed_control.h>
#include <sandglass/material/material_constants.h>

#include <sstream>

namespace Sandglass
{
  /// A law alone, at one material point.
  template <typename Law>
  class ElementTest
  {
  public:
    using Point = MaterialPoint<Law>;

    /// Throws InputError where the law doesn't admit the initial stress. The
    /// law has to live as long as this object.
    ElementTest(const Law                 &law,
                const MaterialConstants   &constants,
                const ElementTestSettings &settings,
                const StressIntegration    integration)
      : law(law)
      , settings(settings)
      , integration(integration)
      , start(initial_point(constants))
    {}

    /**
     * Call `observe(row)` with the start and after each step.
     *
     * Throws RunError where the test can't go on.
     */
    template <typename Observe>
    void
    run(const Observe &observe) const
    {
      MixedControl<Law> control(law, settings, integration);
      Point             point = start;
      observe(row_of(point));
      for (unsigned int n = 1; n <= settings.n_steps; ++n)
        {
          const Point  before = point;
          const double strain = settings.axial_strain * n / settings.n_steps;
          if (!control.drive(point, strain))
            fail(n, point, control);
          const bool is_last = has_reached_largest_stress(point);
          if (is_last)
            point = at_largest_stress(before, point, control);
          observe(row_of(point));
          if (is_last)
            return;
        }
    }

  private:
    /**
     * The law's initial state at the initial stress. What hardens with stress,
     * such as a cap, is not that far yet: as long as the law doesn't keep the
     * stress without strain, but its state changes, the stress is put back.
     */
    Point
    initial_point(const MaterialConstants &constants) const
    {
      constexpr int    most_returns = 100000;
      constexpr double tolerance    = 1e-6;

      const auto                  &initial = settings.initial_stress;
      const SymmetricComponents<4> stress(-initial[1],
                                          -initial[0],
                                          -initial[2],
                                          0.);
      check_lateral_stress(constants);
      Point point;
      point.stress = stress;
      point.state  = law.initial_state();
      for (int n = 0; n < most_returns; ++n)
        {
          const Point  next   = without_strain(point);
          const double change = (next.stress - stress).cwiseAbs().maxCoeff();
          if (change <= tolerance * std::max(1., stress.cwiseAbs().maxCoeff()))
            return point;
          if (next.state == point.state || !is_finite(next))
            break;
          point.state = next.state;
        }
      refuse_initial_stress(
        "the law '" + constants.model +
        "' doesn't admit this stress; allowed is one within "
        "its strength");
    }

    /// What the law makes of a point that doesn't move.
    Point
    without_strain(const Point &point) const
    {
      try
        {
          return deformed(
            point, UniformGradient(), law, integration, settings.time_step());
        }
      catch (const std::exception &error)
        {
          refuse_initial_stress(error.what());
        }
    }

    /// Without cohesion nothing can be loaded beside a free surface.
    void
    check_lateral_stress(const MaterialConstants &constants) const
    {
      const auto &initial = settings.initial_stress;
      // What a user's own law can is not known.
      const bool may_be_free = (Law::has_cohesion && constants.cohesion > 0.) ||
                               !constants.umat_library.empty();
      const bool is_free =
        (settings.kind == ElementTestKind::triaxial &&
         (initial[1] == 0. || initial[2] == 0.)) ||
        (settings.kind == ElementTestKind::biaxial && initial[1] == 0.) ||
        (settings.is_shear() && initial[0] == 0.);
      if (is_free && !may_be_free)
        refuse_initial_stress(
          "without cohesion, a stress that is held must be greater than 0");
    }

    [[noreturn]] void
    refuse_initial_stress(const std::string &why) const
    {
      std::ostringstream text;
      const auto        &initial = settings.initial_stress;
      text << initial[0] << ", " << initial[1] << ", " << initial[2];
      throw InputError("Element test", "Initial stress", text.str(), why);
    }

    ElementTestRow
    row_of(const Point &point) const
    {
      // 0. - x, since -x would make -0 of no stress.
      ElementTestRow row;
      row.axial_strain =
        settings.is_shear() ? 1. - point.stretch[1] : point.driven_strain;
      row.volumetric_strain   = point.volumetric_strain();
      row.shear_strain        = point.shear;
      row.axial_stress        = 0. - point.stress[Component::yy];
      row.lateral_stress      = 0. - point.stress[Component::xx];
      row.out_of_plane_stress = 0. - point.stress[Component::zz];
      row.shear_stress        = point.stress[Component::xy];
      row.void_ratio          = state_variable<Law>(point.state, "void ratio");
      return row;
    }

    bool
    has_reached_largest_stress(const Point &point) const
    {
      return settings.largest_axial_stress > 0. &&
             -point.stress[Component::yy] >= settings.largest_axial_stress;
    }

    /// Where in a step the largest axial stress is reached, by bisection.
    Point
    at_largest_stress(const Point       &before,
                      const Point       &after,
                      MixedControl<Law> &control) const
    {
      Point  result = after;
      double below  = before.driven_strain;
      double above  = after.driven_strain;
      for (int n = 0; n < 40; ++n)
        {
          const double middle = 0.5 * (below + above);
          Point        point  = before;
          if (middle == below || middle == above ||
              !control.drive(point, middle))
            break;
          const bool is_reached        = has_reached_largest_stress(point);
          (is_reached ? above : below) = middle;
          if (is_reached)
            result = point;
        }
      return result;
    }

    [[noreturn]] void
    fail(const unsigned int       n,
         const Point             &point,
         const MixedControl<Law> &control) const
    {
      const ElementTestRow row = row_of(point);
      std::ostringstream   message;
      message << "Element test of the law '" << Law::name << "', step " << n
              << " of " << settings.n_steps << ", at an axial strain of "
              << row.axial_strain;
      if (settings.is_shear())
        message << ", a shear strain of " << row.shear_strain;
      message << ", stresses (axial, lateral, out of plane, shear) of "
              << row.axial_stress << ", " << row.lateral_stress << ", "
              << row.out_of_plane_stress << ", " << row.shear_stress
              << " Pa: " << control.complaint()
              << ". The material may have failed: then try a smaller Element "
                 "test/Axial strain; otherwise more Steps.";
      throw RunError(message.str());
    }

    const Law                &law;
    const ElementTestSettings settings;
    const StressIntegration   integration;
    const Point               start;
  };
} // namespace Sandglass

#endif
