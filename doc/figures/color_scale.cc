#include "color_scale.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace Figures
{
  namespace
  {
    /// Matplotlib's viridis, whose steps look equally large.
    constexpr std::array<Color, 9> viridis = {{{{68, 1, 84}},
                                               {{71, 45, 123}},
                                               {{59, 82, 139}},
                                               {{44, 114, 142}},
                                               {{33, 145, 140}},
                                               {{40, 174, 128}},
                                               {{94, 201, 98}},
                                               {{173, 220, 48}},
                                               {{253, 231, 37}}}};

    const std::map<std::string, std::string> units = {{"speed", "m/s"},
                                                      {"velocity", "m/s"},
                                                      {"stress", "Pa"},
                                                      {"pressure", "Pa"},
                                                      {"density", "kg/m³"},
                                                      {"displacement", "m"},
                                                      {"mass", "kg"}};
  } // namespace



  ColorScale::ColorScale(std::vector<double> values)
  {
    // A few particles with extreme values must not take up the scale.
    std::sort(values.begin(), values.end());
    const double low   = values[values.size() / 100];
    const double high  = values[values.size() * 99 / 100];
    const double range = std::max(high - low, 1e-6 * std::abs(high) + 1e-30);

    step = std::pow(10., std::floor(std::log10(range)));
    step /= range < 2. * step ? 5. : range < 5. * step ? 2. : 1.;
    begin = std::floor(low / step) * step;
    end   = std::ceil(high / step + 1e-6) * step;
  }



  Color
  ColorScale::color(const double value) const
  {
    const double place = std::clamp((value - begin) / (end - begin), 0., 1.) *
                         (viridis.size() - 1.);
    const unsigned int i = std::min<unsigned int>(place, viridis.size() - 2);
    Color              color;
    for (unsigned int c = 0; c < color.size(); ++c)
      color[c] = std::lround(viridis[i][c] +
                             (place - i) * (viridis[i + 1][c] - viridis[i][c]));
    return color;
  }



  void
  ColorScale::draw(Canvas              &canvas,
                   const Canvas::Point &lower_left,
                   const double         height,
                   const std::string   &field) const
  {
    constexpr double width     = 24.;
    constexpr int    text_size = 26;
    const double     left = lower_left[0], bottom = lower_left[1];
    for (double y = 0.; y < height; ++y)
      canvas.draw_line({{left, bottom + y}},
                       {{left + width, bottom + y}},
                       2.,
                       color(begin + (end - begin) * y / height));

    const int n_steps = std::lround((end - begin) / step);
    for (int i = 0; i <= n_steps; ++i)
      {
        std::ostringstream number;
        number << (std::lround(begin / step) + i) * step;
        canvas.draw_text(number.str(),
                         {{left + width + 12., bottom + height * i / n_steps}},
                         text_size,
                         false);
      }

    const std::size_t colon = std::min(field.find(':'), field.size());
    const auto        unit  = units.find(field.substr(0, colon));
    std::string       title = field;
    if (colon < field.size())
      title[colon] = ' ';
    if (unit != units.end())
      title += ", " + unit->second;
    canvas.draw_text(title, {{left, bottom + height + 40.}}, text_size, false);
  }
} // namespace Figures
