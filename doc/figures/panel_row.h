#ifndef sandglass_figures_panel_row_h
#define sandglass_figures_panel_row_h

#include <vtkBoundingBox.h>

#include "pen.h"

namespace Figures
{
  /// A picture of panels of one size next to each other, with a label below
  /// each, and room for a colour bar to the right of them.
  class PanelRow
  {
  public:
    /// @param box  what a panel shows, in m.
    PanelRow(const unsigned int    n_panels,
             const vtkBoundingBox &box,
             const bool            draws_mirror_image,
             const bool            has_bar);

    /// The next panel from the left, with its label.
    Pen
    next_panel(const std::string &label);

    /// In pixels: the left end of what comes next, and the panels' bottom.
    Canvas::Point
    next_corner() const;

    static constexpr int text_size = 30;

    Canvas canvas;
    double panel_width, panel_height; ///< in pixels

  private:
    struct Size
    {
      double scale, panel_width, panel_height, width, height;
    };

    static Size
    find_size(const unsigned int    n_panels,
              const vtkBoundingBox &box,
              const bool            has_bar);

    PanelRow(const Size           &size,
             const vtkBoundingBox &box,
             const bool            draws_mirror_image);

    const double        scale; ///< pixels per m
    const Canvas::Point origin_in_panel;
    const bool          draws_mirror_image;
    double              left;
  };
} // namespace Figures

#endif
