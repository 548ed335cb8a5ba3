#include "panel_row.h"

#include <algorithm>
#include <stdexcept>

namespace Figures
{
  namespace
  {
    // In pixels.
    constexpr double largest_width = 1800., largest_height = 1000.;
    constexpr double margin = 20., gap = 36., bar_space = 210.;
    constexpr double label_space = 56.;
  } // namespace



  PanelRow::Size
  PanelRow::find_size(const unsigned int    n_panels,
                      const vtkBoundingBox &box,
                      const bool            has_bar)
  {
    const double width_around =
      2. * margin + (n_panels - 1.) * gap + (has_bar ? bar_space : 0.);
    const double height_around = 2. * margin + label_space;
    if (width_around > .5 * largest_width)
      throw std::runtime_error("So many times don't fit into one picture.");

    Size size;
    size.scale =
      std::min((largest_width - width_around) / (n_panels * box.GetLength(0)),
               (largest_height - height_around) / box.GetLength(1));
    size.panel_width  = size.scale * box.GetLength(0);
    size.panel_height = size.scale * box.GetLength(1);
    size.width        = n_panels * size.panel_width + width_around;
    size.height       = size.panel_height + height_around;
    return size;
  }



  PanelRow::PanelRow(const unsigned int    n_panels,
                     const vtkBoundingBox &box,
                     const bool            draws_mirror_image,
                     const bool            has_bar)
    : PanelRow(find_size(n_panels, box, has_bar), box, draws_mirror_image)
  {}



  PanelRow::PanelRow(const Size           &size,
                     const vtkBoundingBox &box,
                     const bool            draws_mirror_image)
    : canvas(size.width, size.height)
    , panel_width(size.panel_width)
    , panel_height(size.panel_height)
    , scale(size.scale)
    , origin_in_panel(
        {{-size.scale * box.GetBound(0), -size.scale * box.GetBound(2)}})
    , draws_mirror_image(draws_mirror_image)
    , left(margin)
  {}



  Pen
  PanelRow::next_panel(const std::string &label)
  {
    const auto corner = next_corner();
    canvas.draw_text(label,
                     {{left + .5 * panel_width, margin + .5 * text_size}},
                     text_size,
                     true);
    left += panel_width + gap;
    return {canvas,
            {{corner[0] + origin_in_panel[0], corner[1] + origin_in_panel[1]}},
            scale,
            draws_mirror_image};
  }



  Canvas::Point
  PanelRow::next_corner() const
  {
    return {{left, margin + label_space}};
  }
} // namespace Figures
