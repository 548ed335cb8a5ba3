#include "canvas.h"

#include <vtkDataArray.h>
#include <vtkImageShrink3D.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Figures
{
  namespace
  {
    /// Pixels drawn per pixel written, in each direction.
    constexpr int fineness = 4;
  } // namespace



  Canvas::Canvas(const double width, const double height)
  {
    image->SetDimensions(fineness * std::lround(width),
                         fineness * std::lround(height),
                         1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    image->GetPointData()->GetScalars()->Fill(255);
  }



  void
  Canvas::draw_line(const Point &begin,
                    const Point &end,
                    const double thickness,
                    const Color &color)
  {
    const double radius = fineness * thickness / 2.;
    const double x = fineness * begin[0], y = fineness * begin[1];
    const double dx = fineness * end[0] - x, dy = fineness * end[1] - y;
    const double length_square = dx * dx + dy * dy;

    const int *size  = image->GetDimensions();
    const auto clamp = [](const double value, const int n) {
      return std::clamp(static_cast<int>(value), 0, n);
    };
    const int i_begin = clamp(x + std::min(dx, 0.) - radius, size[0]);
    const int i_end   = clamp(x + std::max(dx, 0.) + radius + 1., size[0]);
    const int j_begin = clamp(y + std::min(dy, 0.) - radius, size[1]);
    const int j_end   = clamp(y + std::max(dy, 0.) + radius + 1., size[1]);
    for (int j = j_begin; j < j_end; ++j)
      for (int i = i_begin; i < i_end; ++i)
        {
          // From the line's beginning to the pixel's centre.
          const double px = i + .5 - x, py = j + .5 - y;
          const double fraction =
            length_square == 0. ?
              0. :
              std::clamp((px * dx + py * dy) / length_square, 0., 1.);
          if (std::hypot(px - fraction * dx, py - fraction * dy) <= radius)
            std::copy(color.begin(),
                      color.end(),
                      static_cast<unsigned char *>(
                        image->GetScalarPointer(i, j, 0)));
        }
  }



  void
  Canvas::draw_text(const std::string &text,
                    const Point       &position,
                    const int          size,
                    const bool         is_centered)
  {
    vtkNew<vtkTextProperty> style;
    style->SetFontSize(fineness * size);
    style->SetFontFamilyToTimes();
    style->SetColor(.15, .15, .15);

    // Colour and opacity; the image may be larger than the text.
    vtkNew<vtkImageData> letters;
    std::array<int, 2>   extent;
    constexpr int        points_per_inch = 72; // sizes are in pixels
    vtkTextRenderer::GetInstance()->RenderString(
      style, text, letters, extent.data(), points_per_inch);

    const int left =
      std::lround(fineness * position[0]) - (is_centered ? extent[0] / 2 : 0);
    const int  bottom     = std::lround(fineness * position[1]) - extent[1] / 2;
    const int *image_size = image->GetDimensions();
    for (int j = 0; j < extent[1]; ++j)
      for (int i = 0; i < extent[0]; ++i)
        {
          if (left + i < 0 || left + i >= image_size[0] || bottom + j < 0 ||
              bottom + j >= image_size[1])
            continue;
          const auto *source =
            static_cast<unsigned char *>(letters->GetScalarPointer(i, j, 0));
          auto *target = static_cast<unsigned char *>(
            image->GetScalarPointer(left + i, bottom + j, 0));
          for (unsigned int c = 0; c < 3; ++c)
            target[c] += (source[c] - target[c]) * source[3] / 255;
        }
  }



  void
  Canvas::write(const std::string &filename)
  {
    vtkNew<vtkImageShrink3D> shrink;
    shrink->SetInputData(image);
    shrink->SetShrinkFactors(fineness, fineness, 1);
    shrink->MeanOn();

    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(shrink->GetOutputPort());
    writer->SetFileName(filename.c_str());
    writer->SetCompressionLevel(9);
    writer->Write();
    if (writer->GetErrorCode() != 0)
      throw std::runtime_error("'" + filename + "' can't be written.");
  }
} // namespace Figures
