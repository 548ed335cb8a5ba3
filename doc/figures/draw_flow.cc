// Draws a run's particles at some times side by side into a PNG file, as in
// Figures 3, 4, 7 and 8 of Wieckowski, Youn and Yeon (1999).

#include <vtkBoundingBox.h>
#include <vtkObject.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "canvas.h"
#include "color_scale.h"
#include "run_output.h"

namespace
{
  using namespace Figures;

  const std::string usage =
    "Usage: draw_flow [OPTIONS] OUTPUT_DIRECTORY PICTURE.png TIME...\n"
    "Draws the particles at the times of the output next to each TIME, in s.\n"
    "  --half        the half section that was computed\n"
    "  --whole       both halves (the default)\n"
    "  --field NAME  colours for speed, pressure, stress:YY, ... instead of\n"
    "                the layers of the initial material\n";

  // In pixels.
  constexpr double largest_width = 1800., largest_height = 1000., margin = 20.;
  constexpr double gap = 36., bar_space = 210., label_space = 56.;
  constexpr int    text_size = 30;

  struct Options
  {
    std::vector<std::string> arguments; ///< directory, picture, times
    std::string              field    = "layer";
    bool                     is_whole = true;
  };



  Options
  parse_options(const std::vector<std::string> &words)
  {
    Options options;
    for (auto word = words.begin(); word != words.end(); ++word)
      if (*word == "--half" || *word == "--whole")
        options.is_whole = *word == "--whole";
      else if (*word == "--field" && word + 1 != words.end())
        options.field = *++word;
      else if (word->rfind("--", 0) == 0)
        throw std::runtime_error("The option " + *word +
                                 " is unknown or lacks its value.\n" + usage);
      else
        options.arguments.push_back(*word);
    if (options.arguments.size() < 3)
      throw std::runtime_error("Arguments are missing.\n" + usage);
    return options;
  }



  struct Panel
  {
    double                               time; ///< in s
    vtkSmartPointer<vtkUnstructuredGrid> particles;
    std::vector<double>                  values; ///< that give the colours
  };



  std::vector<Panel>
  read_panels(const Options &options, const Series &series)
  {
    std::vector<Panel> panels;
    for (unsigned int i = 2; i < options.arguments.size(); ++i)
      {
        std::istringstream text(options.arguments[i]);
        double             time;
        if (!(text >> time && text.eof()))
          throw std::runtime_error("'" + text.str() + "' is no time in s.");
        const auto entry     = find_nearest(series, time);
        const auto particles = read_grid(entry->second);
        panels.push_back(
          {entry->first, particles, field_values(*particles, options.field)});
      }
    return panels;
  }



  /// In m. Discs of this size just about cover the initial material.
  double
  particle_diameter(vtkUnstructuredGrid &initial)
  {
    // As if the material filled its bounding box with a square grid. Holes
    // between the particles that Gmsh's triangles make are a bit larger.
    const vtkBoundingBox box(initial.GetBounds());
    return 1.5 * std::sqrt(box.GetLength(0) * box.GetLength(1) /
                           initial.GetNumberOfPoints());
  }



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



  void
  draw_particles(const Pen                       &pen,
                 const Panel                     &panel,
                 const double                     diameter,
                 const std::optional<ColorScale> &color_scale)
  {
    constexpr Color dark_sand  = {{150, 94, 42}};
    constexpr Color light_sand = {{236, 200, 136}};
    for (unsigned int i = 0; i < panel.values.size(); ++i)
      {
        const double *const point = panel.particles->GetPoint(i);
        const double        value = panel.values[i];
        const Color         layer_color =
          std::lround(value) % 2 == 1 ? dark_sand : light_sand;
        pen.draw_line(point,
                      point,
                      pen.scale * diameter,
                      color_scale ? color_scale->color(value) : layer_color);
      }
  }



  void
  draw_walls(const Pen &pen, vtkUnstructuredGrid &walls)
  {
    constexpr Color wall_color = {{38, 42, 48}}, outlet_color = {{80, 80, 80}};

    // The outlet lies between the axis and the point of the walls next to it.
    vtkPoints            &points = *walls.GetPoints();
    std::array<double, 3> lip, begin, end;
    points.GetPoint(0, lip.data());
    for (vtkIdType i = 1; i < points.GetNumberOfPoints(); ++i)
      if (points.GetPoint(i)[0] < lip[0])
        points.GetPoint(i, lip.data());
    const std::array<double, 3> middle = {{0., lip[1], 0.}};
    pen.draw_line(middle.data(), lip.data(), 2., outlet_color);

    for (vtkIdType i = 0; i < walls.GetNumberOfCells(); ++i)
      {
        points.GetPoint(walls.GetCell(i)->GetPointId(0), begin.data());
        points.GetPoint(walls.GetCell(i)->GetPointId(1), end.data());
        pen.draw_line(begin.data(), end.data(), 5., wall_color);
      }
  }



  std::string
  time_label(const double time, const std::vector<Panel> &panels)
  {
    double longest_time = 0.;
    for (const auto &panel : panels)
      longest_time = std::max(longest_time, panel.time);
    // As many decimals as all times need. Output waits for the end of a time
    // step, so 0.5002 s means 0.5 s.
    const auto is_short = [longest_time](const double time,
                                         const int    decimals) {
      return std::abs(std::remainder(time, std::pow(10., -decimals))) <=
             1e-3 * longest_time;
    };
    int decimals = 1;
    for (const auto &panel : panels)
      while (decimals < 4 && !is_short(panel.time, decimals))
        ++decimals;

    std::ostringstream label;
    label << "t = " << std::fixed << std::setprecision(decimals) << time
          << " s";
    return label.str();
  }



  std::optional<ColorScale>
  make_color_scale(const Options &options, const std::vector<Panel> &panels)
  {
    if (options.field == "layer")
      return {};
    std::vector<double> values;
    for (const auto &panel : panels)
      values.insert(values.end(), panel.values.begin(), panel.values.end());
    return ColorScale(values);
  }



  /// Panels of one size next to each other, with a label below each, and room
  /// for a colour bar to the right of them. In pixels where nothing else is
  /// said.
  struct Layout
  {
    /// @param box  what a panel shows, in m.
    Layout(const unsigned int    n_panels,
           const vtkBoundingBox &box,
           const bool            has_bar)
    {
      const double width_around =
        2. * margin + (n_panels - 1.) * gap + (has_bar ? bar_space : 0.);
      const double height_around = 2. * margin + label_space;
      if (width_around > .5 * largest_width)
        throw std::runtime_error("So many times don't fit into one picture.");
      scale =
        std::min((largest_width - width_around) / (n_panels * box.GetLength(0)),
                 (largest_height - height_around) / box.GetLength(1));
      panel_width  = scale * box.GetLength(0);
      panel_height = scale * box.GetLength(1);
      width        = n_panels * panel_width + width_around;
      height       = panel_height + height_around;
    }

    double scale; ///< pixels per m
    double panel_width, panel_height, width, height;
  };



  void
  draw(const Options &options)
  {
    const std::string &directory = options.arguments[0];
    const Series       series    = read_series(directory, "particles");
    const auto         panels    = read_panels(options, series);
    const auto         walls =
      read_grid(read_series(directory, "walls").rbegin()->second);
    const auto   color_scale = make_color_scale(options, panels);
    const double diameter =
      particle_diameter(*read_grid(series.begin()->second));

    vtkBoundingBox box(walls->GetBounds());
    for (const auto &panel : panels)
      box.AddBounds(panel.particles->GetBounds());
    if (options.is_whole)
      box.AddPoint(-box.GetBound(1), box.GetBound(2), 0.);
    const Layout layout(panels.size(), box, color_scale.has_value());

    Canvas       canvas(layout.width, layout.height);
    const double bottom = margin + label_space;
    double       left   = margin;
    for (const auto &panel : panels)
      {
        const Pen pen{canvas,
                      {{left - layout.scale * box.GetBound(0),
                        bottom - layout.scale * box.GetBound(2)}},
                      layout.scale,
                      options.is_whole};
        draw_particles(pen, panel, diameter, color_scale);
        draw_walls(pen, *walls);
        canvas.draw_text(time_label(panel.time, panels),
                         {{left + .5 * layout.panel_width,
                           margin + .5 * text_size}},
                         text_size,
                         true);
        left += layout.panel_width + gap;
      }
    if (color_scale)
      color_scale->draw(canvas,
                        {{left, bottom + .15 * layout.panel_height}},
                        .7 * layout.panel_height,
                        options.field);
    canvas.write(options.arguments[1]);
  }
} // namespace



int
main(int argc, char *argv[])
{
  // VTK's own messages would only say less clearly what ours say.
  vtkObject::GlobalWarningDisplayOff();
  try
    {
      const std::vector<std::string> words(argv + 1, argv + argc);
      if (words == std::vector<std::string>{"--help"})
        std::cout << usage;
      else
        draw(parse_options(words));
      return 0;
    }
  catch (const std::exception &error)
    {
      std::cerr << "draw_flow: " << error.what() << std::endl;
      return 2;
    }
}
