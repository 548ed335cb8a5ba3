#ifndef sandglass_material_lade_integration_h
#define sandglass_material_lade_integration_h

#include <sandglass/material/lade_surfaces.h>

namespace Sandglass
{
  /**
   * Integrates Lade's law over one strain increment in as many substeps as a
   * bound on the error asks for: Heun's rule, whose difference from Euler's
   * estimates the error, and after each substep a return to the yield surfaces
   * (as Sloan, Abbo and Sheng 2001 do).
   */
  template <int n>
  class LadeIntegration
  {
  public:
    /// @param tolerance  relative error of the stress in one substep.
    LadeIntegration(const LadeConstants &constants, const double tolerance)
      : constants(constants)
      , tolerance(tolerance)
    {}

    /// @param strain  compression positive.
    void
    integrate(LadePoint<n> &point, const SymmetricComponents<n> &strain) const
    {
      // Whatever the increment, this ends after 1 / smallest_substep substeps.
      constexpr double smallest_substep = 1e-3;
      double           done = 0., substep = 1.;
      if (!return_to_surfaces(point))
        make_admissible(point);
      while (done < 1.)
        {
          substep              = std::min(substep, 1. - done);
          const bool   is_last = substep <= smallest_substep;
          LadePoint<n> next    = point;
          const double error   = try_substep(next, substep * strain);
          if (error <= tolerance || is_last)
            {
              point = next;
              done  = substep >= 1. - done ? 1. : done + substep;
              if (!return_to_surfaces(point))
                make_admissible(point);
              if (is_separated(point, strain))
                return;
            }
          // The error goes with the square of the substep.
          const double factor =
            0.9 * std::sqrt(tolerance / std::max(error, 1e-3 * tolerance));
          substep =
            std::max(smallest_substep, substep * std::clamp(factor, 0.1, 4.));
        }
    }

    /**
     * Bring a stress that is no stress of the material into the cone of
     * failure: none at all where the pressure is not positive, otherwise with a
     * smaller deviator.
     */
    void
    make_admissible(LadePoint<n> &point) const
    {
      const double mean = trace(point.stress) / 3.;
      if (!(mean > constants.floor_pressure))
        {
          point.stress = isotropic<n>(constants.floor_pressure);
          return;
        }
      const SymmetricComponents<n> s = point.stress - isotropic<n>(mean);
      if (is_admissible(point.stress))
        return;
      double inside = 0., outside = 1.;
      for (unsigned int i = 0; i < 50; ++i)
        {
          const double middle = 0.5 * (inside + outside);
          (is_admissible(isotropic<n>(mean) + middle * s) ? inside : outside) =
            middle;
        }
      point.stress = isotropic<n>(mean) + inside * s;
    }

  private:
    using Surfaces = LadeSurfaces<n>;
    template <typename T>
    using Both = std::array<T, 2>;

    /// Within a hair of the cone of failure.
    bool
    is_admissible(const SymmetricComponents<n> &stress) const
    {
      const Surfaces at(constants, {stress, {{1., 1.}}, 0.});
      return at.is_compressed && at.cone <= constants.failure * (1. + 1e-6);
    }

    /// Whether a point has lost its stress, and goes on expanding.
    bool
    is_separated(LadePoint<n>                 &point,
                 const SymmetricComponents<n> &strain) const
    {
      if (trace(point.stress) > 3. * constants.floor_pressure)
        return false;
      point.stress = isotropic<n>(constants.floor_pressure);
      return trace(strain) <= 0.;
    }

    /// @return the relative error of stress and work; infinite if the stress
    ///         left all that the law knows.
    double
    try_substep(LadePoint<n> &point, const SymmetricComponents<n> &strain) const
    {
      const LadePoint<n> first = rate(point, strain);
      const LadePoint<n> end   = sum(point, first, 1.);
      const Surfaces     at_end(constants, end);
      if (!at_end.is_compressed)
        {
          point = end;
          return 1e300;
        }
      const LadePoint<n> second = rate(end, strain);
      point                     = sum(sum(point, first, 0.5), second, 0.5);

      const double size =
        std::sqrt(double_contraction(point.stress, point.stress));
      double error =
        0.5 * (second.stress - first.stress).cwiseAbs().maxCoeff() / size;
      for (unsigned int i = 0; i < 2; ++i)
        error = std::max(error,
                         0.5 * std::abs(second.work[i] - first.work[i]) /
                           (point.work[i] + 1e-3 * size));
      return std::isfinite(error) ? error : 1e300;
    }

    static LadePoint<n>
    sum(LadePoint<n> point, const LadePoint<n> &change, const double factor)
    {
      point.stress += factor * change.stress;
      for (unsigned int i = 0; i < 2; ++i)
        point.work[i] += factor * change.work[i];
      point.dissipation += factor * change.dissipation;
      return point;
    }

    /// By how much a strain changes the point, to first order.
    LadePoint<n>
    rate(const LadePoint<n> &point, const SymmetricComponents<n> &strain) const
    {
      const Surfaces at(constants, point);
      const auto     elasticity = at.elasticity();
      LadePoint<n>   change{elasticity.stress(strain), {{0., 0.}}, 0.};
      if (!at.is_compressed)
        return change;

      Both<double> demand;
      Both<bool>   may_yield;
      for (unsigned int i = 0; i < 2; ++i)
        {
          demand[i]    = double_contraction(at.gradient[i], change.stress);
          may_yield[i] = at.excess[i] >= -at.margin[i];
        }
      add_plastic_flow(at, elasticity, demand, may_yield, change);
      return change;
    }

    /**
     * Let the surfaces that may yield do so as far as `demand` says: the growth
     * of their excesses without plastic flow.
     */
    static void
    add_plastic_flow(const Surfaces     &at,
                     const Elasticity   &elasticity,
                     const Both<double> &demand,
                     const Both<bool>   &may_yield,
                     LadePoint<n>       &change)
    {
      Both<SymmetricComponents<n>> relief;
      Both<double>                 work;
      for (unsigned int i = 0; i < 2; ++i)
        {
          relief[i] = elasticity.stress(at.flow[i]);
          work[i]   = std::max(0., double_contraction(at.stress, at.flow[i]));
        }
      Eigen::Matrix2d matrix;
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          matrix(i, j) = double_contraction(at.gradient[i], relief[j]);
      for (unsigned int i = 0; i < 2; ++i)
        {
          // Where softening outruns the elastic relief no increment would do.
          const double elastic = std::abs(matrix(i, i));
          matrix(i, i) =
            std::max(1e-3 * elastic, matrix(i, i) + at.hardening[i] * work[i]);
        }

      const Both<double> flow = multipliers(matrix, demand, may_yield);
      for (unsigned int i = 0; i < 2; ++i)
        {
          change.stress -= flow[i] * relief[i];
          change.work[i] += flow[i] * work[i];
          change.dissipation +=
            flow[i] *
            (work[i] - at.constants.floor_pressure * trace(at.flow[i]));
        }
    }

    /// Not negative, zero for surfaces that don't yield, such that no excess
    /// grows (Koiter's rule).
    static Both<double>
    multipliers(const Eigen::Matrix2d &matrix,
                const Both<double>    &demand,
                const Both<bool>      &may_yield)
    {
      Both<double> alone = {{0., 0.}};
      for (unsigned int i = 0; i < 2; ++i)
        if (may_yield[i] && demand[i] > 0. && matrix(i, i) > 0.)
          alone[i] = demand[i] / matrix(i, i);
      if (!may_yield[0] || !may_yield[1])
        return alone;

      const Both<bool> other_still_yields = {
        {demand[1] > matrix(1, 0) * alone[0],
         demand[0] > matrix(0, 1) * alone[1]}};
      if (!other_still_yields[0])
        return {{alone[0], 0.}};
      if (!other_still_yields[1])
        return {{0., alone[1]}};
      const double determinant = matrix.determinant();
      if (determinant > 0.)
        {
          const Both<double> both = {
            {(matrix(1, 1) * demand[0] - matrix(0, 1) * demand[1]) /
               determinant,
             (matrix(0, 0) * demand[1] - matrix(1, 0) * demand[0]) /
               determinant}};
          if (both[0] >= 0. && both[1] >= 0.)
            return both;
        }
      return alone;
    }

    /// Newton's method on the excesses, at fixed strain. False if the stress
    /// is not, or not near, one of the material.
    bool
    return_to_surfaces(LadePoint<n> &point) const
    {
      for (unsigned int i = 0; i < 20; ++i)
        {
          const Surfaces at(constants, point);
          if (!at.is_compressed)
            return false;
          const Both<bool> is_outside = {
            {at.excess[0] > at.tolerance[0], at.excess[1] > at.tolerance[1]}};
          if (!is_outside[0] && !is_outside[1])
            return true;
          const auto   elasticity = at.elasticity();
          LadePoint<n> change{SymmetricComponents<n>::Zero(), {{0., 0.}}, 0.};
          add_plastic_flow(at, elasticity, at.excess, is_outside, change);
          point = sum(point, change, 1.);
        }
      return false;
    }

    const LadeConstants &constants;
    const double         tolerance;
  };
} // namespace Sandglass

#endif
