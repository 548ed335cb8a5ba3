#ifndef sandglass_material_umat_h
#define sandglass_material_umat_h

#include <sandglass/base/exceptions.h>
#include <sandglass/continuum/material_tangent.h>
#include <sandglass/material/elasticity.h>
#include <sandglass/material/lane_by_lane.h>
#include <sandglass/material/law_defaults.h>
#include <sandglass/material/law_failure.h>
#include <sandglass/material/numerical_tangent.h>
#include <sandglass/material/rotation_increment.h>
#include <sandglass/material/umat_library.h>

#include <algorithm>
#include <sstream>

namespace Sandglass
{
  /**
   * A law of the user's own, in a shared library with Abaqus' user-material
   * subroutine; doc/user-guide.md says what it is given. It is called for one
   * particle after the other.
   *
   * The stress that it gets has been turned by the step's rotation already.
   * State variables that are tensors it turns itself, by DROT.
   */
  class Umat : public LawDefaults
  {
  public:
    static constexpr char name[] = "UMAT";
    static constexpr char description[] =
      "a subroutine of the user's in Abaqus' form, from a shared library";

    /// Largest number of state variables; particles have room for all of them.
    static constexpr unsigned int max_state_variables = 20;

    static constexpr std::array<StateVariable, 1> state_variables = {
      {{"UMAT state", "1", max_state_variables}}};

    // All that is not known of it.
    static constexpr bool dissipation_can_fall = true;
    static constexpr bool can_fail             = true;

    static bool
    is_meant(const MaterialConstants &constants)
    {
      return constants.model == name;
    }

    /// Throws InputError where the library or a number is not as it should be.
    explicit Umat(const MaterialConstants &constants)
      : elasticity(constants.young_modulus, constants.poisson_ratio)
      , n_state_variables(constants.n_umat_state_variables)
      , library(checked(constants))
    {}

    /// Zeros.
    std::array<double, max_state_variables>
    initial_state() const
    {
      return {};
    }

    double
    loosest_density_share() const
    {
      return 1.;
    }

    /// Strain, rotation and time step, in this order.
    template <typename Increment>
    auto
    predict(const Increment &increment, const double time_step) const
    {
      using Strain         = std::decay_t<decltype(increment.strain)>;
      using Number         = typename Strain::Scalar;
      constexpr int n      = Strain::RowsAtCompileTime;
      const auto    turn   = rotation_numbers_of(increment);
      constexpr int n_turn = std::tuple_size<decltype(turn)>::value;

      Eigen::Matrix<Number, n + n_turn + 1, 1> prediction;
      for (int c = 0; c < n; ++c)
        prediction[c] = increment.strain[c];
      for (int i = 0; i < n_turn; ++i)
        prediction[n + i] = turn[i];
      prediction[n + n_turn] = Number(time_step);
      return prediction;
    }

    /**
     * Throws LawFailure if the subroutine asks for a smaller step or returns
     * what is not a number.
     *
     * @return the work of the mean stress per volume in J/m^3. How much of it
     *         is stored is not known, so it all counts as dissipated.
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
        [this](auto &stress_of_one, auto &state_of_one, const auto &given) {
          UmatCall call = make_call(stress_of_one, state_of_one, given);
          run(call);
          Eigen::Matrix<double, n, 1> strain = given.template head<n>();
          Eigen::Matrix<double, n, 1> middle = 0.5 * stress_of_one;
          for (int c = 0; c < n; ++c)
            stress_of_one[c] = call.stress[place(c)];
          middle += 0.5 * stress_of_one;
          std::copy(call.state.begin(), call.state.end(), state_of_one.begin());
          return double_contraction(middle, strain);
        });
    }

    /**
     * With respect to the strain what the subroutine says (DDSDDE), or, where
     * that is zero, differences; with respect to the stress differences.
     *
     * @param elastic_share  from 0, the derivative, to 1, the stiffness bound.
     */
    template <int n, typename State, typename Increment>
    MaterialTangent<n>
    tangent(const Eigen::Matrix<double, n, 1> &stress,
            const State                       &state,
            const Increment                   &increment,
            const double                       elastic_share) const
    {
      MaterialTangent<n> result =
        numerical_tangent(*this, stress, state, increment);
      UmatCall call = make_call(stress, state, predict(increment, 0.));
      run(call);
      const auto is_zero = [](const double x) { return x == 0.; };
      if (!std::all_of(call.stiffness.begin(), call.stiffness.end(), is_zero))
        for (int d = 0; d < n; ++d)
          for (int c = 0; c < n; ++c)
            result.by_strain(c, d) = (d < Component::first_shear ? 1. : 2.) *
                                     call.stiffness[place(c) + n * place(d)];

      // As in DruckerPrager: a node all of whose cells carry no stress must not
      // have an equation of zeros.
      const bool is_stressed =
        !std::all_of(call.stress.begin(), call.stress.end(), is_zero);
      const double share =
        is_stressed ? elastic_share : std::max(1e-3, elastic_share);
      return with_elastic_share(result, elasticity, share);
    }

    /// What the user gives as Young's modulus and Poisson's ratio: an
    /// elasticity that the subroutine is nowhere stiffer than.
    Elasticity
    stiffness_bound() const
    {
      return elasticity;
    }

    template <int n, typename State>
    Elasticity
    stiffness_bound(const Eigen::Matrix<double, n, 1> &, const State &) const
    {
      return elasticity;
    }

    /// Not known: zero.
    template <int n, typename Number, typename State>
    Number
    energy_density(const Eigen::Matrix<Number, n, 1> &, const State &) const
    {
      return Number(0.);
    }

  private:
    static const MaterialConstants &
    checked(const MaterialConstants &constants)
    {
      if (constants.n_umat_state_variables > max_state_variables)
        throw InputError("Material",
                         "UMAT state variables",
                         std::to_string(constants.n_umat_state_variables),
                         "at most " + std::to_string(max_state_variables));
      return constants;
    }

    /// Where Abaqus' order has a component of ours: yz and xz change places.
    static int
    place(const int component)
    {
      constexpr int yz = 4, xz = 5;
      return component == yz ? xz : component == xz ? yz : component;
    }

    template <int n, typename State, int n_prediction>
    UmatCall
    make_call(const Eigen::Matrix<double, n, 1>            &stress,
              const State                                  &state,
              const Eigen::Matrix<double, n_prediction, 1> &prediction) const
    {
      UmatCall call(n - Component::first_shear);
      for (int c = 0; c < n; ++c)
        {
          const double factor   = c < Component::first_shear ? 1. : 2.;
          call.stress[place(c)] = stress[c];
          call.strain_increment[place(c)] = factor * prediction[c];
        }
      call.state.assign(state.begin(), state.begin() + n_state_variables);

      constexpr int              n_turn = n_prediction - n - 1;
      std::array<double, n_turn> turn;
      for (int i = 0; i < n_turn; ++i)
        turn[i] = prediction[n + i];
      call.rotation  = rotation_matrix(turn);
      call.time_step = prediction[n_prediction - 1];
      return call;
    }

    /// The subroutine, and whether it has done what it should.
    void
    run(UmatCall &call) const
    {
      const UmatCall given = call;
      try
        {
          library(call);
        }
      catch (const LawFailure &failure)
        {
          fail(failure.what(), given);
        }
      if (!(call.new_time_step_share >= 1.))
        fail("it asks for a smaller step (PNEWDT = " +
               std::to_string(call.new_time_step_share) + ")",
             given);
      for (const auto *numbers : {&call.stress, &call.state})
        for (const double number : *numbers)
          if (!std::isfinite(number))
            fail("it returned a stress or state variable that is not finite",
                 given);
    }

    [[noreturn]] static void
    fail(const std::string &why, const UmatCall &given)
    {
      std::ostringstream message;
      message.precision(10);
      const auto list = [&message](const auto &numbers) {
        for (std::size_t i = 0; i < numbers.size(); ++i)
          message << (i > 0 ? ", " : "") << numbers[i];
        message << ')';
      };
      message << "the law " << name << " failed: " << why
              << "; in its order of components, stress before (Pa) (";
      list(given.stress);
      message << ", strain increment (shear as engineering strain) (";
      list(given.strain_increment);
      message << ", state variables (";
      list(given.state);
      throw LawFailure(message.str());
    }

    const Elasticity   elasticity; ///< given as a bound
    const unsigned int n_state_variables;
    const UmatLibrary  library;
  };
} // namespace Sandglass

#endif
