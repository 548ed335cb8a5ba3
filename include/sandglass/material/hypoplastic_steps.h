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
   * Heun's step for the whole increment, two evaluations of the law, is enough
   * for small ones: while it differs from Euler's by no more than
   * heun_tolerance. Otherwise steps of Merson's method follow, of fourth order
   * and five evaluations each, as long as their estimated error allows. A
   * method of high order pays: strain keeps its direction throughout an
   * increment, so the law is smooth there, but sand's stress changes altogether
   * within a strain of a thousandth.
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
    integrate(const Stress &start) const
    {
      // Unstressed material that doesn't want pressure stays so.
      Stress     first = rate(start, Number(0.));
      const auto stays = stays_unstressed(start, first);
      for (int c = 0; c < n; ++c)
        first[c] = select(stays, Number(0.), first[c]);
      const Number whole = select(stays, Number(0.), Number(1.));

      const Stress second =
        whole * rate(without_tension(start + first), Number(1.));
      Stress stress = admissible(start + Number(0.5) * (first + second));

      // As a share of the stress, squared.
      const Number error =
        Number(0.25) * squared_norm(second - first) / squared_scale(start);
      const auto is_rough = error > Number(heun_tolerance * heun_tolerance);
      if (!any(is_rough))
        return stress;

      Number done = select(is_rough, Number(0.), Number(1.));
      for (int c = 0; c < n; ++c)
        stress[c] = select(is_rough, start[c], stress[c]);
      go_on(stress, done, first_share(error));
      return stress;
    }

  private:
    // As shares of the pressure: by how much Heun's step may differ from
    // Euler's, and the error of a step of Merson's method. Errors add up along
    // a path; from no stress to 1 MPa they stay below 1e-4.
    static constexpr double heun_tolerance   = 2e-4;
    static constexpr double merson_tolerance = 3e-6;
    /// Shortest step as a share of the increment; it is taken as it is.
    static constexpr double smallest_share = 1e-3;
    /// Of the increment; the sum of the steps may miss 1 by rounding.
    static constexpr double almost_all = 1. - 1e-9;

    /// Steps of Merson's method, until all lanes are through the increment.
    /// @param done,share  of the increment: what is behind, and the next step.
    void
    go_on(Stress &stress, Number &done, Number share) const
    {
      do
        {
          const auto   is_through = done > Number(almost_all);
          Stress       result     = stress;
          const Number error      = merson_step(result, done, share);
          // What isn't a number is not refused, and so stays visible.
          const Number excess =
            select(share > Number(smallest_share), error, Number(0.));
          const auto is_refused = excess > Number(1.);
          const auto is_kept    = is_through | is_refused;

          result = admissible(result);
          for (int c = 0; c < n; ++c)
            stress[c] = select(is_kept, stress[c], result[c]);
          done  = done + select(is_kept, Number(0.), share);
          share = next_share(share, done, error);
        }
      while (any(done < Number(almost_all)));
    }

    /**
     * One step of Merson's (1957) method.
     *
     * @return the square of the error's estimate, 1 where it is as large as it
     * may be.
     */
    Number
    merson_step(Stress &stress, const Number &done, const Number &share) const
    {
      const Number third  = Number(1. / 3.) * share;
      const Number half   = Number(0.5) * share;
      const Number sixth  = Number(1. / 6.) * share;
      const Number eighth = Number(0.125) * share;

      const Stress k1 = rate(stress, done);
      const Stress k2 =
        rate(without_tension(stress + third * k1), done + third);
      const Stress k3 =
        rate(without_tension(stress + sixth * (k1 + k2)), done + third);
      const Stress k4 =
        rate(without_tension(stress + eighth * (k1 + Number(3.) * k3)),
             done + half);
      const Stress k5 =
        rate(without_tension(stress +
                             half * (k1 - Number(3.) * k3 + Number(4.) * k4)),
             done + share);
      const Stress error =
        sixth * Number(0.2) *
        (Number(2.) * k1 - Number(9.) * k3 + Number(8.) * k4 - k5);
      const Number scale = squared_scale(stress);
      stress += sixth * (k1 + Number(4.) * k4 + k5);
      return squared_norm(error) /
             (Number(merson_tolerance * merson_tolerance) * scale);
    }

    /// The law's rate of stress for the whole increment.
    Stress
    rate(const Stress &stress, const Number &share) const
    {
      return law.stress_rate(stress, void_ratio(share), strain, strain_norm);
    }

    /// Without tension, and with the deviator bounded.
    Stress
    admissible(const Stress &stress) const
    {
      return without_tension(bounded(stress));
    }

    /// Length of the first step after Heun's has failed, whose error is half
    /// the square of the ratio by which the stress wants to change.
    static Number
    first_share(const Number &squared_error)
    {
      using std::sqrt;
      const Number ratio = sqrt(Number(2.) * sqrt(squared_error));
      return within_bounds(Number(0.5) / ratio, Number(0.));
    }

    /// The error is proportional to the fifth power of the length.
    static Number
    next_share(const Number &share,
               const Number &done,
               const Number &squared_error)
    {
      constexpr double safety = 0.8, largest_growth = 4., largest_cut = 0.1;
      const Number     factor =
        Number(safety) * power(squared_error + Number(1e-30), Number(-0.1));
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
    squared_scale(const Stress &stress) const
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
