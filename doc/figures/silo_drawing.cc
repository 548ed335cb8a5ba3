#include "silo_drawing.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "run_output.h"

namespace Figures
{
  namespace
  {
    using Vector = std::array<double, 3>;

    Vector
    point_of(vtkUnstructuredGrid &grid, const vtkIdType point)
    {
      Vector position;
      grid.GetPoint(point, position.data());
      return position;
    }



    /// The unit normal of the line from `a` to `b` that points away from the
    /// material: outwards or downwards, as each wall of a silo has it.
    Vector
    outer_normal(const Vector &a, const Vector &b)
    {
      const double x      = b[1] - a[1];
      const double y      = a[0] - b[0];
      const double length = std::copysign(std::hypot(x, y), x - y);
      return {{x / length, y / length, 0.}};
    }



    struct Line
    {
      Vector begin, end;
    };

    /// Where the lines of a traction run, given in Pa at the walls' points.
    std::vector<Line>
    traction_lines(vtkUnstructuredGrid &walls,
                   const std::string   &field,
                   const double         length_per_traction)
    {
      const std::vector<double> tractions = field_values(walls, field);
      std::vector<Line>         lines;
      for (vtkIdType i = 0; i < walls.GetNumberOfCells(); ++i)
        {
          const vtkIdType begin = walls.GetCell(i)->GetPointId(0);
          const vtkIdType end   = walls.GetCell(i)->GetPointId(1);
          Line            line = {point_of(walls, begin), point_of(walls, end)};
          const Vector    normal = outer_normal(line.begin, line.end);
          for (unsigned int c = 0; c < 2; ++c)
            {
              line.begin[c] +=
                length_per_traction * tractions[begin] * normal[c];
              line.end[c] += length_per_traction * tractions[end] * normal[c];
            }
          lines.push_back(line);
        }
      return lines;
    }
  } // namespace



  void
  draw_walls(const Pen &pen, vtkUnstructuredGrid &walls)
  {
    constexpr Color wall_color = {{38, 42, 48}}, outlet_color = {{80, 80, 80}};

    // The outlet lies between the axis and the point of the walls next to it.
    Vector lip = point_of(walls, 0);
    for (vtkIdType i = 1; i < walls.GetNumberOfPoints(); ++i)
      if (point_of(walls, i)[0] < lip[0])
        lip = point_of(walls, i);
    const Vector middle = {{0., lip[1], 0.}};
    pen.draw_line(middle.data(), lip.data(), 2., outlet_color);

    for (vtkIdType i = 0; i < walls.GetNumberOfCells(); ++i)
      pen.draw_line(point_of(walls, walls.GetCell(i)->GetPointId(0)).data(),
                    point_of(walls, walls.GetCell(i)->GetPointId(1)).data(),
                    5.,
                    wall_color);
  }



  void
  draw_mesh(const Pen &pen, vtkUnstructuredGrid &mesh)
  {
    constexpr Color mesh_color = {{120, 124, 130}};
    for (vtkIdType i = 0; i < mesh.GetNumberOfCells(); ++i)
      {
        vtkIdList *const points = mesh.GetCell(i)->GetPointIds();
        for (vtkIdType k = 0; k < points->GetNumberOfIds(); ++k)
          pen.draw_line(
            point_of(mesh, points->GetId(k)).data(),
            point_of(mesh, points->GetId((k + 1) % points->GetNumberOfIds()))
              .data(),
            1.,
            mesh_color);
      }
  }



  TractionDrawing::TractionDrawing(const double        length,
                                   std::vector<double> tractions)
  {
    // A single node with a jump of its force must not shrink all others.
    std::sort(tractions.begin(), tractions.end());
    const double typical =
      std::max(tractions[tractions.size() * 97 / 100], 1e-10);
    length_per_traction = length / typical;

    round_traction = std::pow(10., std::floor(std::log10(typical)));
    round_traction *= typical >= 5. * round_traction ? 5. :
                      typical >= 2. * round_traction ? 2. :
                                                       1.;
  }



  void
  TractionDrawing::draw(const Pen &pen, vtkUnstructuredGrid &walls) const
  {
    constexpr Color normal_color     = {{24, 78, 140}};
    constexpr Color tangential_color = {{178, 34, 34}};
    for (const auto &line :
         traction_lines(walls, "normal traction", length_per_traction))
      pen.draw_line(line.begin.data(), line.end.data(), 3.5, normal_color);
    for (const auto &line :
         traction_lines(walls, "tangential traction", length_per_traction))
      pen.draw_line(line.begin.data(), line.end.data(), 1.5, tangential_color);
  }



  void
  TractionDrawing::extend(vtkBoundingBox &box, vtkUnstructuredGrid &walls) const
  {
    for (const auto &line :
         traction_lines(walls, "normal traction", length_per_traction))
      {
        box.AddPoint(line.begin[0], line.begin[1], 0.);
        box.AddPoint(line.end[0], line.end[1], 0.);
      }
  }



  void
  TractionDrawing::draw_scale(const Pen           &pen,
                              const Canvas::Point &left_end,
                              const int            text_size) const
  {
    const double length = pen.scale * length_per_traction * round_traction;
    const Canvas::Point right_end = {{left_end[0] + length, left_end[1]}};
    constexpr Color     color     = {{24, 78, 140}};
    pen.canvas.draw_line(left_end, right_end, 3.5, color);

    std::ostringstream number;
    if (round_traction >= 1000.)
      number << round_traction / 1000. << " kPa";
    else
      number << round_traction << " Pa";
    pen.canvas.draw_text(number.str(),
                         {{left_end[0], left_end[1] + .8 * text_size}},
                         text_size,
                         false);
  }
} // namespace Figures
