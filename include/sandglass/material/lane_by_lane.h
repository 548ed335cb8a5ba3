#ifndef sandglass_material_lane_by_lane_h
#define sandglass_material_lane_by_lane_h

#include <sandglass/base/lanes.h>
#include <sandglass/material/law_failure.h>

#include <array>
#include <cstddef>

namespace Sandglass
{
  /// A number that all lanes share, in any of them.
  inline double
  number_of_lane(const double number, const unsigned int /*lane*/)
  {
    return number;
  }

  inline double
  number_of_lane(const Lanes &numbers, const unsigned int lane)
  {
    return numbers[lane];
  }

  /// One particle's share of a vector of numbers of several.
  template <typename Number, int n>
  Eigen::Matrix<double, n, 1>
  vector_of_lane(const Eigen::Matrix<Number, n, 1> &vector,
                 const unsigned int                 lane)
  {
    Eigen::Matrix<double, n, 1> result;
    for (int i = 0; i < n; ++i)
      result[i] = number_of_lane(vector[i], lane);
    return result;
  }

  /**
   * correct() of a law that has to branch, or that is not ours to write with
   * lanes: `correct_one(stress, state, prediction)` on one particle after the
   * other, in doubles. Here for one particle alone.
   *
   * @param[in,out] stress,state  as a law's correct() takes them.
   * @return what `correct_one` returns.
   */
  template <int n, std::size_t n_state, typename Prediction, typename Function>
  double
  lane_by_lane(Eigen::Matrix<double, n, 1> &stress,
               std::array<double, n_state> &state,
               const Prediction            &prediction,
               const Function              &correct_one)
  {
    return correct_one(stress, state, vector_of_lane(prediction, 0));
  }

  /// As above, for four particles. Their prediction may be one that they share.
  template <int n, std::size_t n_state, typename Prediction, typename Function>
  Lanes
  lane_by_lane(Eigen::Matrix<Lanes, n, 1> &stress,
               std::array<Lanes, n_state> &state,
               const Prediction           &prediction,
               const Function             &correct_one)
  {
    // Lanes are written as a whole, so collect what each number becomes.
    alignas(Lanes) double new_stress[n][Lanes::n];
    alignas(Lanes) double new_state[n_state + 1][Lanes::n];
    alignas(Lanes) double result[Lanes::n];
    for (unsigned int lane = 0; lane < Lanes::n; ++lane)
      {
        auto stress_of_one = vector_of_lane(stress, lane);
        std::array<double, n_state> state_of_one;
        for (std::size_t i = 0; i < n_state; ++i)
          state_of_one[i] = state[i][lane];
        try
          {
            result[lane] = correct_one(stress_of_one,
                                       state_of_one,
                                       vector_of_lane(prediction, lane));
          }
        catch (LawFailure &failure)
          {
            failure.lane = lane;
            throw;
          }
        for (int c = 0; c < n; ++c)
          new_stress[c][lane] = stress_of_one[c];
        for (std::size_t i = 0; i < n_state; ++i)
          new_state[i][lane] = state_of_one[i];
      }
    for (int c = 0; c < n; ++c)
      stress[c] = Lanes::load(new_stress[c]);
    for (std::size_t i = 0; i < n_state; ++i)
      state[i] = Lanes::load(new_state[i]);
    return Lanes::load(result);
  }
} // namespace Sandglass

#endif
