#ifndef sandglass_figures_silo_drawing_h
#define sandglass_figures_silo_drawing_h

#include <vtkBoundingBox.h>
#include <vtkUnstructuredGrid.h>

#include "pen.h"

namespace Figures
{
  /// The walls, and a line across the outlet.
  void
  draw_walls(const Pen &pen, vtkUnstructuredGrid &walls);

  /// The edges of the cells.
  void
  draw_mesh(const Pen &pen, vtkUnstructuredGrid &mesh);

  /**
   * What the walls carry, drawn along them on their outer side: the normal
   * tractions thick, the tangential ones thin, and inside where negative.
   */
  class TractionDrawing
  {
  public:
    /// @param length     in m, of a traction that few nodes exceed.
    /// @param tractions  all normal tractions that will be drawn, in Pa.
    TractionDrawing(const double length, std::vector<double> tractions);

    void
    draw(const Pen &pen, vtkUnstructuredGrid &walls) const;

    /// Make the box large enough for these tractions.
    void
    extend(vtkBoundingBox &box, vtkUnstructuredGrid &walls) const;

    /// A bar as long as a round traction, with that number above it.
    void
    draw_scale(const Pen           &pen,
               const Canvas::Point &left_end,
               const int            text_size) const;

  private:
    double length_per_traction; ///< in m/Pa
    double round_traction;      ///< in Pa
  };
} // namespace Figures

#endif
