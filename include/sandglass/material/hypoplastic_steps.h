#ifndef sandglass_material_hypoplastic_steps_h
#define sandglass_material_hypoplastic_steps_h

#include <sandglass/base/lanes_functions.h>
#include <sandglass/continuum/symmetric_components.h>

#include <cmath>

namespace Sandglass
{
  /**
   * Integration of a hypoplastic law over one increment of strain, for one
   * particle or for a block of them.
   *
   * Heun's step for the whole increment, two evaluations of the law, is usually
   * enough: it is when it differs from Euler's by no more than a ten-thousandth
   * of the stress. Otherwise a third evaluation makes it a Runge-Kutta step of
   * third order (Shu and Osher 1988), which is taken if Heun's differs from it
   * by a quarter as much, and else is repeated with a shorter one.
   *
   * Each lane has steps of its own, and is left alone once it is through: its
   * result doesn't depend on its neighbours, nor on the number of ranks.
   */
  template <typename Law, int n, typename Number>
  class HypoplasticSteps
  {
  public:
    using Stress = SymmetricComponents<n, Number>;

    /// @param small_pressure  p_t in Pa
    HypoplasticSteps(const Law    &law,
                     const double  small_pressure,
                     const Stress &strain,
                     const Number &initial_void_ratio)
      : law(law)
      , small_pressure(small_pressure)
      , strain(strain)
      , volume_change(trace(strain))
      , one_and_void_ratio(Number(1.) + initial_void_ratio)
    {
      using std::sqrt;
      strain_norm = sqrt(double_contraction(strain, strain));
    }

    /// 1 + e = (1 + e_0) exp(tr D t), as a series, after a share of the
    /// increment.
    Number
    void_ratio(const Number &share) const
    {
      const Number x = share * volume_change;
      return one_and_void_ratio *
               (Number(1.) + x * (Number(1.) + x * (Number(1. / 2.) +
                                                    x * Number(1. / 6.)))) -
             Number(1.);
    }

    /// The stress that the law sees: with p_t, and without tension.
    Stress
    shift(const Stress &stress) const
    {
      return without_tension(stress - isotropic<n>(Number(small_pressure)));
    }

    /// @param stress  shifted, at the start of the increment.
    /// @return the shifted stress at its end.
    Stress
    integrate(Stress stress) const
    {
      Number done(0.), share(1.);
      do
        {
          const auto is_through = done >= Number(almost_all);
          step(stress, done, share, is_through);
        }
      while (any(done < Number(almost_all)));
      return stress;
    }

  private:
    // Shares of the stress by which two steps of different order may differ:
    // Euler's and Heun's, Heun's and that of third order. The more accurate one
    // is taken, so what is left is less.
    static constexpr double heun_tolerance  = 1e-4;
    static constexpr double third_tolerance = 2.5e-5;
    /// Shortest step as a share of the increment; it is taken as it is.
    static constexpr double smallest_share = 1e-3;
    static constexpr double largest_growth = 4.; ///< from step to step
    /// Of the increment; the sum of the steps may miss 1 by rounding.
    static constexpr double almost_all = 1. - 1e-9;

    /// Try a step, and choose the length of the next one.
    template <typename Mask>
    void
    step(Stress     &stress,
         Number     &done,
         Number     &share,
         const Mask &is_through) const
    {
      // Unstressed material that doesn't want pressure stays so: its steps have
      // no length.
      const Stress first = rate(stress, done);
      const Number length =
        select(stays_unstressed(stress, first), Number(0.), share);
      const Stress second =
        rate(without_tension(stress + length * first), done + share);
      const Stress sum      = first + second;
      const Number scale    = error_scale(stress);
      const Number half     = Number(0.5) * length;
      Stress       result   = stress + half * sum;
      const auto   is_rough = half * half * squared_norm(second - first) >
                            Number(heun_tolerance * heun_tolerance) * scale;
      if (!any(is_rough))
        {
          take(result, is_through, stress);
          done  = done + share;
          share = within_bounds(Number(largest_growth) * share, done);
          return;
        }

      const Number quarter = Number(0.5) * half;
      const Stress third   = rate(without_tension(stress + quarter * sum),
                                done + Number(0.5) * share);
      const Stress bend    = third - Number(0.5) * sum;
      const Number error   = Number(4. / 9.) * length * length *
                           squared_norm(bend) /
                           (Number(third_tolerance * third_tolerance) * scale);
      const Stress third_order = result + Number(2. / 3.) * length * bend;
      for (int c = 0; c < n; ++c)
        result[c] = select(is_rough, third_order[c], result[c]);

      // What isn't a number is not refused, and so stays visible.
      const Number excess =
        select(is_rough,
               select(share > Number(smallest_share), error, Number(0.)),
               Number(0.));
      const auto is_refused = excess > Number(1.);
      take(result, is_through | is_refused, stress);
      done  = done + select(is_refused, Number(0.), share);
      share = next_share(share, done, select(is_rough, error, Number(0.)));
    }

    /// The law's rate of stress for the whole increment.
    Stress
    rate(const Stress &stress, const Number &share) const
    {
      return law.stress_rate(stress, void_ratio(share), strain, strain_norm);
    }

    /// Set the stress to the result of a step, where it isn't to be kept.
    template <typename Mask>
    void
    take(const Stress &result, const Mask &is_kept, Stress &stress) const
    {
      const Stress admissible = without_tension(bounded(result));
      for (int c = 0; c < n; ++c)
        stress[c] = select(is_kept, stress[c], admissible[c]);
    }

    /// The error is proportional to the third power of the length; `error` is
    /// its square, 1 where it is as large as it may be.
    static Number
    next_share(const Number &share, const Number &done, const Number &error)
    {
      constexpr double safety = 0.8, largest_cut = 0.1;
      const Number     factor =
        Number(safety) *
        exponential(Number(-1. / 6.) * logarithm(error + Number(1e-30)));
      const Number growth =
        select(factor < Number(largest_growth), factor, Number(largest_growth));
      return within_bounds(select(growth > Number(largest_cut),
                                  growth,
                                  Number(largest_cut)) *
                             share,
                           done);
    }

    static Number
    within_bounds(const Number &share, const Number &done)
    {
      const Number rest = Number(1.) - done;
      const Number allowed =
        select(share > Number(smallest_share), share, Number(smallest_share));
      return select(allowed < rest, allowed, rest);
    }

    /// The square of the stress that errors are compared with, in Pa^2: the
    /// pressure, and ten times p_t, since nobody needs a fraction of a small
    /// stress that precisely.
    Number
    error_scale(const Stress &stress) const
    {
      const Number scale = pressure(stress) + Number(10. * small_pressure);
      return scale * scale;
    }

    static Number
    squared_norm(const Stress &difference)
    {
      return double_contraction(difference, difference);
    }

    /// Whether pressure isn't above p_t, but for rounding. False for what isn't
    /// a number.
    auto
    is_unstressed(const Stress &stress) const
    {
      return trace(stress) >= Number(-3. * (1. + 1e-12) * small_pressure);
    }

    /// Where pressure isn't above p_t: that and no more.
    Stress
    without_tension(Stress stress) const
    {
      const auto is_tensile = is_unstressed(stress);
      for (int c = 0; c < n; ++c)
        stress[c] =
          select(is_tensile,
                 Number(c < Component::first_shear ? -small_pressure : 0.),
                 stress[c]);
      return stress;
    }

    /**
     * With the deviator's norm at most sqrt(2/3) |tr stress|, as in uniaxial
     * stress: beyond that some stress is tensile. Kolymbas' law leads there
     * where it unloads, the others only by errors of long steps. The comparison
     * makes what isn't a number spread to all components.
     */
    Stress
    bounded(const Stress &stress) const
    {
      using std::sqrt;
      const Number p       = pressure(stress);
      const Stress s       = deviator(stress);
      const Number squared = double_contraction(s, s);
      const Number limit   = Number(6.) * p * p;
      const Number ratio =
        select(squared <= limit, Number(1.), sqrt(limit / squared));
      return ratio * s - isotropic<n>(p);
    }

    /// Unstressed material whose pressure the rate doesn't raise.
    auto
    stays_unstressed(const Stress &stress, const Stress &rate) const
    {
      return is_unstressed(stress) & (trace(rate) >= Number(0.));
    }

    const Law   &law;
    const double small_pressure; ///< p_t in Pa
    const Stress strain;         ///< of the whole increment
    const Number volume_change;
    const Number one_and_void_ratio; ///< at the increment's start
    Number       strain_norm;
  };
} // namespace Sandglass

#endif
