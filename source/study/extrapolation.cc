#include <sandglass/study/extrapolation.h>

#include <boost/math/distributions/students_t.hpp>

#include <cmath>

namespace Sandglass
{
  namespace
  {
    /// A straight line by weighted least squares, as textbooks have it.
    struct Line
    {
      double intercept, slope;
      /// Standard error of the intercept by the scatter about the line.
      double intercept_error;
    };



    /// @param weights  proportional to the inverse variances of y.
    Line
    fitted_line(const std::vector<double> &x,
                const std::vector<double> &y,
                const std::vector<double> &weights)
    {
      double sum = 0., mean_x = 0., mean_y = 0.;
      for (unsigned int i = 0; i < x.size(); ++i)
        {
          sum += weights[i];
          mean_x += weights[i] * x[i];
          mean_y += weights[i] * y[i];
        }
      mean_x /= sum;
      mean_y /= sum;
      double xx = 0., xy = 0.;
      for (unsigned int i = 0; i < x.size(); ++i)
        {
          xx += weights[i] * (x[i] - mean_x) * (x[i] - mean_x);
          xy += weights[i] * (x[i] - mean_x) * (y[i] - mean_y);
        }
      Line line;
      line.slope     = xy / xx;
      line.intercept = mean_y - line.slope * mean_x;

      double residual = 0.;
      for (unsigned int i = 0; i < x.size(); ++i)
        {
          const double error = y[i] - line.intercept - line.slope * x[i];
          residual += weights[i] * error * error;
        }
      line.intercept_error = std::sqrt(residual / (x.size() - 2.) *
                                       (1. / sum + mean_x * mean_x / xx));
      return line;
    }
  } // namespace



  Extrapolation
  extrapolate(const std::vector<double> &sizes,
              const std::vector<double> &values)
  {
    constexpr double outside = 0.05; // of the interval, at both its ends

    if (sizes.size() < 3)
      return {};
    std::vector<double> squares, weights;
    for (const double size : sizes)
      {
        squares.push_back(size * size);
        weights.push_back(1. / (size * size));
      }
    const Line first_order  = fitted_line(sizes, values, weights);
    const Line second_order = fitted_line(squares, values, weights);

    const boost::math::students_t distribution(sizes.size() - 2.);
    const double                  t =
      quantile(boost::math::complement(distribution, outside / 2.));
    return {first_order.intercept,
            first_order.slope,
            std::hypot(t * first_order.intercept_error,
                       first_order.intercept - second_order.intercept)};
  }
} // namespace Sandglass
