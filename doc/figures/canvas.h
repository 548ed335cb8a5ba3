#ifndef sandglass_figures_canvas_h
#define sandglass_figures_canvas_h

#include <vtkImageData.h>
#include <vtkNew.h>

#include <array>
#include <string>

namespace Figures
{
  using Color = std::array<unsigned char, 3>;

  /**
   * A white picture to draw on, in pixels from its lower left corner. Edges
   * come out smooth: it is drawn several times as fine as it is written.
   *
   * VTK's own renderer would need an X server, and so would its users.
   */
  class Canvas
  {
  public:
    using Point = std::array<double, 2>;

    Canvas(const double width, const double height);

    /// A line with round ends; a disc if it has no length.
    void
    draw_line(const Point &begin,
              const Point &end,
              const double thickness,
              const Color &color);

    /// Text around a point, or to the right of it.
    void
    draw_text(const std::string &text,
              const Point       &position,
              const int          size,
              const bool         is_centered);

    /// Write the picture as PNG. Throws std::runtime_error.
    void
    write(const std::string &filename);

  private:
    vtkNew<vtkImageData> image;
  };
} // namespace Figures

#endif
