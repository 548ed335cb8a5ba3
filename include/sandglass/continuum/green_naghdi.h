#ifndef sandglass_continuum_green_naghdi_h
#define sandglass_continuum_green_naghdi_h

#include <sandglass/continuum/in_plane_increment.h>
#include <sandglass/continuum/material_tangent.h>
#include <sandglass/material/law_constant.h>
#include <sandglass/material/state_variable.h>

namespace Sandglass
{
  /**
   * A law in the plane whose stress turns with Green and Naghdi's rate instead
   * of Jaumann's: with the rotation R of the polar decomposition F = R U of the
   * deformation gradient, a state variable of its own (dienes1979).
   *
   * Stress and strain come turned by Jaumann's rotation; here they are turned
   * by the rest. The tangent is Jaumann's: within a load step the two differ by
   * little.
   */
  template <typename Law>
  class GreenNaghdi : public Law
  {
  public:
    static constexpr unsigned int n_of_law = n_state_numbers<Law>();

    static constexpr auto state_variables = []() {
      std::array<StateVariable, Law::state_variables.size() + 1> all{};
      for (std::size_t i = 0; i < Law::state_variables.size(); ++i)
        all[i] = Law::state_variables[i];
      all.back() = {"deformation gradient", "1", 4};
      return all;
    }();

    using Law::Law;

    /// The law's own, and F = 1 row by row.
    std::array<double, n_of_law + 4>
    initial_state() const
    {
      std::array<double, n_of_law + 4> state{};
      const auto                       of_law = Law::initial_state();
      std::copy(of_law.begin(), of_law.end(), state.begin());
      state[n_of_law] = state[n_of_law + 3] = 1.;
      return state;
    }

    /// All that the increment knows: each particle turns it in its own way.
    template <typename Increment>
    auto
    predict(const Increment &increment, const double time_step) const
    {
      using Number = std::decay_t<decltype(increment.jacobian)>;
      Eigen::Matrix<Number, n_predicted, 1> prediction;
      for (int c = 0; c < 4; ++c)
        {
          prediction[strain + c]   = increment.strain[c];
          prediction[gradient + c] = increment.gradient[c / 2][c % 2];
        }
      prediction[rotation]     = increment.rotation.cosine;
      prediction[rotation + 1] = increment.rotation.sine;
      prediction[time]         = Number(time_step);
      return prediction;
    }

    /// See the law's own.
    template <typename Number, typename State, typename Prediction>
    Number
    correct(Eigen::Matrix<Number, 4, 1> &stress,
            State                       &state,
            const Prediction            &prediction) const
    {
      const Rotation<Number> rest =
        rotation_of(state, prediction) -
        Rotation<Number>{Number(prediction[rotation]),
                         Number(prediction[rotation + 1])};
      stress = rotate(stress, rest);
      Turned<Number> increment;
      for (int c = 0; c < 4; ++c)
        increment.strain[c] = Number(prediction[strain + c]);
      increment.strain = rotate(increment.strain, rest.half());
      return Law::correct(stress,
                          state,
                          Law::predict(increment, time_step_of(prediction)));
    }

  private:
    /// Places in the prediction.
    enum : int
    {
      strain      = 0,
      gradient    = 4,
      rotation    = 8,
      time        = 10,
      n_predicted = 11
    };

    template <typename Number>
    struct Rotation : InPlaneRotation<Number>
    {
      Rotation(const Number &cosine, const Number &sine)
        : InPlaneRotation<Number>{cosine, sine}
      {}

      /// This one after the other one backwards.
      Rotation
      operator-(const Rotation &other) const
      {
        const Number scale =
          Number(1.) / (other.cosine * other.cosine + other.sine * other.sine);
        return {scale * (this->cosine * other.cosine + this->sine * other.sine),
                scale *
                  (this->sine * other.cosine - this->cosine * other.sine)};
      }

      /// By half the angle, if that is below a right angle.
      Rotation
      half() const
      {
        using std::sqrt;
        const Number a     = Number(1.) + this->cosine;
        const Number scale = Number(1.) / sqrt(a * a + this->sine * this->sine);
        return {scale * a, scale * this->sine};
      }
    };

    template <typename Number>
    struct Turned
    {
      SymmetricComponents<4, Number> strain;
    };

    /// Move F on, and return the rotation of its R in this step.
    template <typename State, typename Prediction>
    auto
    rotation_of(State &state, const Prediction &prediction) const
    {
      using Number = std::decay_t<decltype(state[0])>;
      using std::sqrt;
      const auto F = [&state](const int i) -> Number & {
        return state[n_of_law + i];
      };
      // R turns by the angle of the vector (F_xx + F_yy, F_yx - F_xy).
      const Number before_x = F(0) + F(3), before_y = F(2) - F(1);
      const Number xx = F(0), xy = F(1), yx = F(2), yy = F(3);
      const Number g[4] = {Number(prediction[gradient]),
                           Number(prediction[gradient + 1]),
                           Number(prediction[gradient + 2]),
                           Number(prediction[gradient + 3])};
      F(0) += g[0] * xx + g[1] * yx;
      F(1) += g[0] * xy + g[1] * yy;
      F(2) += g[2] * xx + g[3] * yx;
      F(3) += g[2] * xy + g[3] * yy;
      const Number after_x = F(0) + F(3), after_y = F(2) - F(1);
      const Number scale =
        Number(1.) / sqrt((before_x * before_x + before_y * before_y) *
                          (after_x * after_x + after_y * after_y));
      const Number cosine = scale * (before_x * after_x + before_y * after_y);
      const Number sine   = scale * (before_x * after_y - before_y * after_x);
      // The pair of InPlaneRotation turns twice as far as the plane.
      return Rotation<Number>{cosine * cosine - sine * sine,
                              Number(2.) * sine * cosine};
    }

    template <typename Prediction>
    static double
    time_step_of(const Prediction &prediction)
    {
      if constexpr (std::is_same_v<typename Prediction::Scalar, double>)
        return prediction[time];
      else
        return prediction[time][0];
    }
  };
} // namespace Sandglass

#endif
