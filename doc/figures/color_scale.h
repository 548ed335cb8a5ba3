#ifndef sandglass_figures_color_scale_h
#define sandglass_figures_color_scale_h

#include <vector>

#include "canvas.h"

namespace Figures
{
  /// Colours for numbers, with a range that begins and ends at round ones.
  class ColorScale
  {
  public:
    explicit ColorScale(std::vector<double> values);

    Color
    color(const double value) const;

    /// Draw the scale as an upright bar with numbers beside it and the field's
    /// name and unit above.
    void
    draw(Canvas              &canvas,
         const Canvas::Point &lower_left,
         const double         height,
         const std::string   &field) const;

  private:
    double begin, end, step;
  };
} // namespace Figures

#endif
