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
#include "panel_row.h"
#include "run_output.h"
#include "silo_drawing.h"

namespace
{
  using namespace Figures;

  const std::string usage =
    "Usage: draw_flow [OPTIONS] OUTPUT_DIRECTORY PICTURE.png TIME...\n"
    "Draws the particles at the times of the output next to each TIME, in s.\n"
    "  --half        the half section that was computed\n"
    "  --whole       both halves (the default)\n"
    "  --paper       as in the paper's figures: the mesh first, then the odd\n"
    "                layers and the tractions along the walls, the normal ones\n"
    "                thick and the tangential ones thin\n"
    "  --field NAME  colours for speed, pressure, stress:YY, ... instead of\n"
    "                the layers of the initial material\n";

  struct Options
  {
    std::vector<std::string> arguments; ///< directory, picture, times
    std::string              field    = "layer";
    bool                     is_whole = true;
    bool                     is_paper = false;
  };



  Options
  parse_options(const std::vector<std::string> &words)
  {
    Options options;
    for (auto word = words.begin(); word != words.end(); ++word)
      if (*word == "--half" || *word == "--whole")
        options.is_whole = *word == "--whole";
      else if (*word == "--paper")
        options.is_paper = true;
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
    vtkSmartPointer<vtkUnstructuredGrid> particles, walls;
    std::vector<double>                  values; ///< that give the colours
  };



  std::vector<Panel>
  read_panels(const Options &options, const Series &series)
  {
    const Series       walls = read_series(options.arguments[0], "walls");
    std::vector<Panel> panels;
    for (unsigned int i = 2; i < options.arguments.size(); ++i)
      {
        std::istringstream text(options.arguments[i]);
        double             time;
        if (!(text >> time && text.eof()))
          throw std::runtime_error("'" + text.str() + "' is no time in s.");
        const auto entry     = find_nearest(series, time);
        const auto particles = read_grid(entry->second);
        panels.push_back({entry->first,
                          particles,
                          read_grid(find_nearest(walls, entry->first)->second),
                          field_values(*particles, options.field)});
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



  void
  draw_particles(const Pen                       &pen,
                 const Panel                     &panel,
                 const double                     diameter,
                 const bool                       draws_odd_layers_only,
                 const std::optional<ColorScale> &color_scale)
  {
    constexpr Color dark_sand  = {{150, 94, 42}};
    constexpr Color light_sand = {{236, 200, 136}};
    for (unsigned int i = 0; i < panel.values.size(); ++i)
      {
        const double *const point       = panel.particles->GetPoint(i);
        const double        value       = panel.values[i];
        const bool          is_odd      = std::lround(value) % 2 == 1;
        const Color         layer_color = is_odd ? dark_sand : light_sand;
        if (draws_odd_layers_only && !is_odd)
          continue;
        pen.draw_line(point,
                      point,
                      pen.scale * diameter,
                      color_scale ? color_scale->color(value) : layer_color);
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



  /// The tractions of all panels, to one scale.
  TractionDrawing
  make_traction_drawing(const std::vector<Panel> &panels)
  {
    std::vector<double> tractions;
    for (const auto &panel : panels)
      {
        const auto values = field_values(*panel.walls, "normal traction");
        tractions.insert(tractions.end(), values.begin(), values.end());
      }
    const vtkBoundingBox walls(panels.front().walls->GetBounds());
    return {.4 * walls.GetBound(1), tractions};
  }



  /// What each panel must have room for, in m.
  vtkBoundingBox
  panel_box(const std::vector<Panel> &panels,
            const Options            &options,
            const TractionDrawing    &tractions)
  {
    vtkBoundingBox box;
    for (const auto &panel : panels)
      {
        box.AddBounds(panel.walls->GetBounds());
        box.AddBounds(panel.particles->GetBounds());
        if (options.is_paper)
          tractions.extend(box, *panel.walls);
      }
    if (options.is_whole)
      box.AddPoint(-box.GetBound(1), box.GetBound(2), 0.);
    return box;
  }



  void
  draw_mesh_panel(PanelRow              &row,
                  const Options         &options,
                  const TractionDrawing &tractions,
                  vtkUnstructuredGrid   &walls)
  {
    const auto corner = row.next_corner();
    const Pen  pen    = row.next_panel("mesh");
    draw_mesh(pen,
              *read_grid(
                read_series(options.arguments[0], "grid").begin()->second));
    draw_walls(pen, walls);
    tractions.draw_scale(pen,
                         {{corner[0] + .72 * row.panel_width, corner[1]}},
                         PanelRow::text_size);
  }



  void
  draw(const Options &options)
  {
    const Series series      = read_series(options.arguments[0], "particles");
    const auto   panels      = read_panels(options, series);
    const auto   tractions   = make_traction_drawing(panels);
    const auto   color_scale = make_color_scale(options, panels);
    const double diameter =
      (options.is_paper ? .6 : 1.) *
      particle_diameter(*read_grid(series.begin()->second));

    PanelRow row(panels.size() + (options.is_paper ? 1 : 0),
                 panel_box(panels, options, tractions),
                 options.is_whole,
                 color_scale.has_value());
    if (options.is_paper)
      draw_mesh_panel(row, options, tractions, *panels.back().walls);
    for (const auto &panel : panels)
      {
        const Pen pen = row.next_panel(time_label(panel.time, panels));
        draw_particles(pen, panel, diameter, options.is_paper, color_scale);
        if (options.is_paper)
          tractions.draw(pen, *panel.walls);
        draw_walls(pen, *panel.walls);
      }
    if (color_scale)
      {
        const auto corner = row.next_corner();
        color_scale->draw(row.canvas,
                          {{corner[0], corner[1] + .15 * row.panel_height}},
                          .7 * row.panel_height,
                          options.field);
      }
    row.canvas.write(options.arguments[1]);
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
