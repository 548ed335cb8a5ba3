#ifndef sandglass_element_test_mixed_control_h
#define sandglass_element_test_mixed_control_h

#include <sandglass/element_test/element_test_settings.h>
#include <sandglass/element_test/material_point.h>

#include <Eigen/LU>

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * Deforms a material point along an element test: one strain is driven, and
   * in the directions in which stress is held the strains are those that
   * Newton's method finds, with a Jacobian by differences. Steps that don't
   * come out are halved.
   */
  template <typename Law>
  class MixedControl
  {
  public:
    using Point = MaterialPoint<Law>;

    /// The law has to live as long as this object.
    MixedControl(const Law                 &law,
                 const ElementTestSettings &settings,
                 const StressIntegration    integration)
      : law(law)
      , settings(settings)
      , integration(integration)
      , held(held_directions(settings.kind))
    {}

    /**
     * Drive a point from the strain that it has to another.
     *
     * @return whether it got there; otherwise the point is where the last part
     * of the step ended that came out, and complaint() says why.
     */
    bool
    drive(Point &point, const double strain)
    {
      return drive(point, strain, 0);
    }

    /// Why the last part of a step did not come out.
    const std::string &
    complaint() const
    {
      return why;
    }

  private:
    /// One number for each direction in which stress is held, at most two.
    using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 2, 1>;
    using Jacobian =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2>;

    /// Of the stresses that are held, relative.
    static constexpr double tolerance     = 1e-8;
    static constexpr int    most_halvings = 16;

    struct Trial
    {
      Unknowns unknowns;
      Point    point;
      Unknowns residual;
      /// The largest residual; infinite where the law has no answer.
      double error = std::numeric_limits<double>::infinity();
    };

    /// What of the displacement gradient is unknown.
    static std::vector<int>
    held_directions(const ElementTestKind kind)
    {
      switch (kind)
        {
          case ElementTestKind::triaxial:
            return {Component::xx, Component::zz};
          case ElementTestKind::biaxial:
            return {Component::xx};
          case ElementTestKind::simple_shear:
            return {Component::yy};
          default:
            return {};
        }
    }

    bool
    drive(Point &point, const double strain, const int n_halvings)
    {
      const double increment = strain - point.driven_strain;
      if (const auto solution = solve(point, increment))
        {
          point               = solution->point;
          point.driven_strain = strain;
          // Rounding must not add up over the steps.
          if (settings.is_shear())
            point.shear = strain;
          else
            point.stretch[1] = 1. - strain;
          last_rate = solution->unknowns / increment;
          return true;
        }
      if (n_halvings == most_halvings)
        return false;
      const double middle = strain - 0.5 * increment;
      return drive(point, middle, n_halvings + 1) &&
             drive(point, strain, n_halvings + 1);
    }

    /// From what the last step found, from no strain, and from that which keeps
    /// the volume.
    std::optional<Trial>
    solve(const Point &start, const double increment)
    {
      const Unknowns none = Unknowns::Zero(held.size());
      if (held.empty())
        return solve_from(none, start, increment);
      if (last_rate.size() == none.size())
        if (const auto solution =
              solve_from(increment * last_rate, start, increment))
          return solution;
      if (const auto solution = solve_from(none, start, increment))
        return solution;
      return settings.is_shear() ?
               std::nullopt :
               solve_from(Unknowns::Constant(held.size(),
                                             increment / held.size()),
                          start,
                          increment);
    }

    std::optional<Trial>
    solve_from(const Unknowns &guess,
               const Point    &start,
               const double    increment)
    {
      constexpr int most_iterations = 50;
      Trial         trial           = try_out(guess, start, increment);
      for (int n = 0; n < most_iterations && std::isfinite(trial.error); ++n)
        {
          if (trial.error <= tolerance)
            return trial;
          const Unknowns change = newton_change(trial, start, increment);
          if (!change.allFinite() || !improve(trial, change, start, increment))
            break;
        }
      if (std::isfinite(trial.error))
        why = "no strain was found that holds the stress";
      return {};
    }

    Unknowns
    newton_change(const Trial &trial,
                  const Point &start,
                  const double increment)
    {
      const double difference = 1e-6 * std::abs(increment);
      Jacobian     jacobian(held.size(), held.size());
      for (unsigned int i = 0; i < held.size(); ++i)
        {
          Unknowns beside = trial.unknowns;
          beside[i] += difference;
          jacobian.col(i) =
            (try_out(beside, start, increment).residual - trial.residual) /
            difference;
        }
      return -jacobian.fullPivLu().solve(trial.residual);
    }

    /// Go as far along a change as the error falls.
    bool
    improve(Trial          &trial,
            const Unknowns &change,
            const Point    &start,
            const double    increment)
    {
      constexpr double least_share = 1e-4;
      for (double share = 1.; share > least_share; share *= 0.5)
        {
          const Trial next =
            try_out(trial.unknowns + share * change, start, increment);
          if (next.error < (1. - 1e-3 * share) * trial.error)
            {
              trial = next;
              return true;
            }
        }
      return false;
    }

    Trial
    try_out(const Unknowns &unknowns,
            const Point    &start,
            const double    increment)
    {
      Trial           trial{unknowns, start, Unknowns::Zero(held.size())};
      UniformGradient gradient;
      if (settings.is_shear())
        gradient.shear = increment / start.stretch[1];
      else
        gradient.normal[1] = -increment / start.stretch[1];
      for (unsigned int i = 0; i < held.size(); ++i)
        gradient.normal[held[i]] = unknowns[i];
      if (!gradient.is_moderate())
        {
          why = "the strain of one step is too large";
          return trial;
        }
      try
        {
          trial.point = deformed(start,
                                 gradient,
                                 law,
                                 integration,
                                 std::abs(increment) / settings.strain_rate);
        }
      catch (const std::exception &error)
        {
          why = error.what();
          return trial;
        }
      if (is_finite(trial.point))
        set_residual(trial);
      else
        why = "the stress is no longer finite";
      return trial;
    }

    void
    set_residual(Trial &trial) const
    {
      constexpr double smallest_scale = 1e-3; // in Pa
      trial.error                     = 0.;
      for (unsigned int i = 0; i < held.size(); ++i)
        {
          const double target = held_stress(held[i]);
          // A stress held at zero is measured by the others.
          const double scale =
            target > 0. ? target :
                          std::max(smallest_scale,
                                   trial.point.stress.cwiseAbs().maxCoeff());
          trial.residual[i] = (trial.point.stress[held[i]] + target) / scale;
          trial.error = std::max(trial.error, std::abs(trial.residual[i]));
        }
    }

    /// In Pa, compression positive.
    double
    held_stress(const int component) const
    {
      const auto &initial = settings.initial_stress;
      return component == Component::yy ? initial[0] :
             component == Component::xx ? initial[1] :
                                          initial[2];
    }

    const Law                &law;
    const ElementTestSettings settings;
    const StressIntegration   integration;
    const std::vector<int>    held; ///< directions in which stress is held

    Unknowns    last_rate; ///< of the unknowns, by the driven strain
    std::string why;
  };
} // namespace Sandglass

#endif
