#ifndef sandglass_figures_pen_h
#define sandglass_figures_pen_h

#include "canvas.h"

namespace Figures
{
  /// Draws between points in m on one panel of the canvas.
  struct Pen
  {
    Canvas             &canvas;
    const Canvas::Point origin; ///< of the scene's coordinates, in pixels
    const double        scale;  ///< pixels per m
    const bool          draws_mirror_image;

    /// @param thickness  in pixels.
    void
    draw_line(const double *begin,
              const double *end,
              const double  thickness,
              const Color  &color) const
    {
      for (const double side : {1., -1.})
        if (side > 0. || draws_mirror_image)
          canvas.draw_line({{origin[0] + side * scale * begin[0],
                             origin[1] + scale * begin[1]}},
                           {{origin[0] + side * scale * end[0],
                             origin[1] + scale * end[1]}},
                           thickness,
                           color);
    }
  };
} // namespace Figures

#endif
