#ifndef sandglass_material_lade_h
#define sandglass_material_lade_h

#include <sandglass/continuum/material_tangent.h>
#include <sandglass/material/lade_integration.h>
#include <sandglass/material/lane_by_lane.h>
#include <sandglass/material/law_defaults.h>
#include <sandglass/material/numerical_tangent.h>

namespace Sandglass
{
  /**
   * Sand by Lade (1977): stiffness by the smallest principal stress; a cone
   * with curved meridians that hardens up to failure, with plastic flow of its
   * own direction, and a spherical cap that yields in compression.
   *
   * Of the constants that all laws share it takes Poisson's ratio. What it adds
   * to Lade: a floor of the pressure, no stress in tension, and what happens
   * after the peak, which his tests end soon after: there the strength stays,
   * and the volumetric flow fades, as in a critical state.
   */
  class Lade : public LawDefaults
  {
  public:
    static constexpr char name[] = "Lade";
    static constexpr char description[] =
      "sand by Lade (1977), cohesionless, with a curved cone that hardens and a "
      "cap";

    static constexpr std::array<StateVariable, 2> state_variables = {
      {{"expansive plastic work", "J/m^3", 1},
       {"collapse plastic work", "J/m^3", 1}}};

    static constexpr bool has_constant_stiffness = false;

    /// Defaults: Lade's for loose Sacramento River sand (void ratio 0.87); the
    /// last six are ours.
    static constexpr std::array<LawConstant, 19> law_constants = {
      {{"K_ur", "1", 960., 1., 1e5, "modulus number of unloading"},
       {"n", "1", 0.57, 0., 0.99, "exponent of the modulus"},
       {"eta_1", "1", 28., 1e-3, 1e4, "f_p at failure"},
       {"m", "1", 0.093, 0., 2., "curvature of the failure surface"},
       {"S", "1", 0.43, -10., 1., "eta_2 by f_p"},
       {"R", "1", -1., -100., 100., "eta_2 by the root of sigma_3 / p_a"},
       {"t", "1", 0., -100., 100., "eta_2 at no stress"},
       {"alpha", "1", 3., 1., 100., "hardening exponent at no pressure"},
       {"beta", "1", -0.076, -10., 10., "hardening exponent by sigma_3 / p_a"},
       {"P", "1", 0.24, 1e-6, 1e3, "plastic work at the peak over p_a"},
       {"l", "1", 1.25, 0., 5., "exponent of the work at the peak"},
       {"C", "1", 0.00028, 1e-9, 1., "collapse modulus"},
       {"p", "1", 0.94, 0.5, 3., "exponent of the collapse"},
       {"residual",
        "1",
        1.,
        0.01,
        1.,
        "share of eta_1 that stays after the peak"},
       {"dilation",
        "1",
        0.,
        0.,
        1.,
        "share of the cone's volumetric flow that stays after the peak"},
       {"p_t", "Pa", 10., 1e-3, 1e6, "floor of the pressure"},
       {"loosest",
        "1",
        0.9,
        0.,
        1.,
        "density below which no stress is carried, over the unstressed one"},
       {"conservative",
        "1",
        1.,
        0.,
        1.,
        "1: elasticity of Lade and Nelson (1987), which conserves energy; 0: "
        "that of 1977, by the smallest principal stress"},
       {"tolerance",
        "1",
        1e-4,
        1e-8,
        1e-1,
        "relative error of the stress in one substep"}}};

    static constexpr bool knows_density         = true;
    static constexpr bool takes_averaged_strain = false;

    static bool
    is_meant(const MaterialConstants &constants)
    {
      return constants.model == name;
    }

    explicit Lade(const MaterialConstants &constants)
      : loosest_share(law_constant<Lade>(constants, "loosest"))
      , tolerance(law_constant<Lade>(constants, "tolerance"))
      , constants(lade_constants(constants))
    {}

    /// The cap passes through the floor of the pressure, where f_c = 3 p_t^2.
    std::array<double, 2>
    initial_state() const
    {
      return {{0., smallest_cap_work()}};
    }

    /// The law dilates, so sand that has been sheared carries stress although
    /// it is looser than at the start. The default's flows at a share of 0.95
    /// under 10 kPa and 0.92 under 100 kPa.
    double
    loosest_density_share() const
    {
      return loosest_share;
    }

    /// The strain: stiffness depends on each particle's stress.
    template <typename Increment>
    auto
    predict(const Increment &increment, const double /*time_step*/) const
    {
      return increment.strain;
    }

    /**
     * @param[in,out] stress  turned, in Pa.
     * @return the plastic work per volume in J/m^3.
     */
    template <int n, typename Number, typename State, typename Prediction>
    Number
    correct(Eigen::Matrix<Number, n, 1> &stress,
            State                       &state,
            const Prediction            &prediction) const
    {
      return lane_by_lane(
        stress,
        state,
        prediction,
        [this](auto &stress_of_one, auto &state_of_one, const auto &strain) {
          return correct_one(stress_of_one, state_of_one, strain);
        });
    }

    /// By differences, as DruckerPrager's otherwise.
    template <int n, typename State, typename Increment>
    MaterialTangent<n>
    tangent(const Eigen::Matrix<double, n, 1> &stress,
            const State                       &state,
            const Increment                   &increment,
            const double                       elastic_share) const
    {
      // A node all of whose cells are separated must not have an equation of
      // zeros.
      return with_elastic_share(
        numerical_tangent(*this, stress, state, increment),
        stiffness_bound(stress, state),
        std::max(1e-3, elastic_share));
    }

    /// Of unstressed material.
    Elasticity
    stiffness_bound() const
    {
      return surfaces(SymmetricComponents<4>::Zero().eval(), {{1., 1.}})
        .elasticity();
    }

    template <int n, typename State>
    Elasticity
    stiffness_bound(const Eigen::Matrix<double, n, 1> &stress,
                    const State &) const
    {
      return surfaces(stress, {{1., 1.}}).elasticity();
    }

    /// What unloading in proportion gives back, since the stiffness goes with
    /// the stress to the power n.
    template <int n, typename Number, typename State>
    Number
    energy_density(const Eigen::Matrix<Number, n, 1> &stress,
                   const State                       &state) const
    {
      auto stress_copy = stress;
      auto state_copy  = state;
      return lane_by_lane(
        stress_copy,
        state_copy,
        stress,
        [this](const auto &, const auto &state_of_one, const auto &of_one) {
          return 2. / (2. - constants.modulus_exponent) *
                 stiffness_bound(of_one, state_of_one).energy_density(of_one);
        });
    }

    /// The surfaces at a stress as it is stored, in Pa, and the plastic works.
    template <int n>
    LadeSurfaces<n>
    surfaces(const Eigen::Matrix<double, n, 1> &stress,
             const std::array<double, 2>       &work) const
    {
      return {constants,
              {isotropic<n>(constants.floor_pressure) - stress, work, 0.}};
    }

  private:
    template <int n>
    double
    correct_one(Eigen::Matrix<double, n, 1>       &stress,
                std::array<double, 2>             &state,
                const Eigen::Matrix<double, n, 1> &strain) const
    {
      if (!stress.allFinite() || !strain.allFinite() ||
          !std::isfinite(state[0]) || !std::isfinite(state[1]))
        {
          // Otherwise it would stay unseen in a component that no force feels.
          stress.setConstant(std::nan(""));
          return std::nan("");
        }
      const LadeIntegration<n> integration(constants, tolerance);
      LadePoint<n>             point = {
                    isotropic<n>(constants.floor_pressure) -
                      limited(stress, largest_stress),
                    {{std::clamp(state[0], 0., largest_stress),
                      std::clamp(state[1], smallest_cap_work(), largest_stress)}},
                    0.};
      integration.integrate(point, -limited(strain, largest_strain));

      stress = isotropic<n>(constants.floor_pressure) -
               limited(point.stress, largest_stress);
      state = point.work;
      return point.dissipation;
    }

    /// With components cut down together. What lies beyond means nothing; it
    /// must only not overflow.
    template <int n>
    static SymmetricComponents<n>
    limited(const Eigen::Matrix<double, n, 1> &tensor, const double largest)
    {
      const double size = tensor.cwiseAbs().maxCoeff();
      if (size <= largest)
        return tensor;
      return tensor * (largest / size);
    }

    double
    smallest_cap_work() const
    {
      constexpr double p_a   = LadeConstants::atmospheric_pressure;
      const double     share = constants.floor_pressure / p_a;
      return constants.collapse * p_a *
             std::pow(3. * share * share, constants.collapse_exponent);
    }

    static LadeConstants
    lade_constants(const MaterialConstants &given)
    {
      const auto get = [&given](const char *const which) {
        return law_constant<Lade>(given, which);
      };
      return {get("K_ur"),
              get("n"),
              given.poisson_ratio,
              get("eta_1"),
              get("m"),
              get("S"),
              get("R"),
              get("t"),
              get("alpha"),
              get("beta"),
              get("P"),
              get("l"),
              get("C"),
              get("p"),
              get("residual"),
              get("dilation"),
              get("p_t"),
              get("conservative") > 0.5};
    }

    static constexpr double largest_stress = 1e12; ///< in Pa
    static constexpr double largest_strain = 1.;

    const double        loosest_share, tolerance;
    const LadeConstants constants;
  };
} // namespace Sandglass

#endif
