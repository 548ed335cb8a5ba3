#include <sandglass/study/convergence_plot.h>

#include <vtkAutoInit.h>
#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkColor.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkRect.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSVGContextDevice2D.h>
#include <vtkTable.h>
#include <vtkXMLDataElement.h>

#include <algorithm>
#include <array>
#include <sstream>

// What makes the letters, and a window for the drawing's size; none is opened.
VTK_MODULE_INIT(vtkRenderingFreeType)
VTK_MODULE_INIT(vtkRenderingOpenGL2)

namespace Sandglass
{
  namespace
  {
    constexpr int width = 600, height = 400; // in pixels

    const vtkColor4ub colour_of_runs(31, 90, 160);
    const vtkColor4ub colour_of_limit(190, 60, 30);



    /// Axes with titles around a study's values, drawn by VTK. Its charts' own
    /// points and lines come out distorted in SVG files (VTK 9.1), so that
    /// those are drawn here, in pixels.
    class Plot
    {
    public:
      Plot(const std::string &title,
           const std::string &title_of_x,
           const std::string &title_of_y)
      {
        root->SetName("svg");
        root->SetAttribute("xmlns", "http://www.w3.org/2000/svg");
        root->SetAttribute("xmlns:xlink", "http://www.w3.org/1999/xlink");
        const int view_box[] = {0, 0, width, height};
        root->SetVectorAttribute("viewBox", 4, view_box);
        definitions->SetName("defs");
        root->AddNestedElement(definitions);
        page->SetName("g");
        page->SetAttribute("fill", "none");
        root->AddNestedElement(page);

        window->SetOffScreenRendering(1);
        window->SetSize(width, height);
        window->AddRenderer(renderer);
        scene->SetRenderer(renderer);
        scene->SetGeometry(width, height);
        scene->AddItem(chart);
        chart->SetAutoSize(false);
        chart->SetSize(vtkRectf(0, 0, width, height));
        chart->SetTitle(title);
        x().SetTitle(title_of_x);
        y().SetTitle(title_of_y);
      }

      /// Draw axes that reach to these points at least.
      void
      draw_axes(const std::vector<std::array<double, 2>> &points)
      {
        vtkNew<vtkTable> table;
        for (unsigned int d = 0; d < 2; ++d)
          {
            vtkNew<vtkDoubleArray> column;
            column->SetName(d == 0 ? "x" : "y");
            for (const auto &point : points)
              column->InsertNextValue(point[d]);
            table->AddColumn(column);
          }
        auto *invisible =
          vtkPlotPoints::SafeDownCast(chart->AddPlot(vtkChart::POINTS));
        invisible->SetInputData(table, 0, 1);
        invisible->SetMarkerStyle(vtkPlotPoints::NONE);

        device->SetSVGContext(page, definitions);
        device->Begin(renderer);
        context->Begin(device);
        scene->Paint(context);
      }

      void
      draw_line(const std::array<double, 2> &start,
                const std::array<double, 2> &end,
                const vtkColor4ub           &colour)
      {
        choose(colour);
        context->DrawLine(pixel(start, 0),
                          pixel(start, 1),
                          pixel(end, 0),
                          pixel(end, 1));
      }

      void
      draw_dot(const std::array<double, 2> &centre, const vtkColor4ub &colour)
      {
        constexpr float radius = 4.;
        choose(colour);
        context->DrawEllipse(pixel(centre, 0),
                             pixel(centre, 1),
                             radius,
                             radius);
      }

      /// The drawing is complete.
      std::string
      text()
      {
        context->End();
        device->GenerateDefinitions();
        std::ostringstream text;
        root->PrintXML(text, vtkIndent());
        return text.str();
      }

    private:
      vtkAxis &
      x()
      {
        return *chart->GetAxis(vtkAxis::BOTTOM);
      }

      vtkAxis &
      y()
      {
        return *chart->GetAxis(vtkAxis::LEFT);
      }

      void
      choose(const vtkColor4ub &colour)
      {
        context->GetPen()->SetColor(colour);
        context->GetPen()->SetWidth(1.5);
        context->GetPen()->SetLineType(vtkPen::SOLID_LINE);
        context->GetBrush()->SetColor(colour);
      }

      float
      pixel(const std::array<double, 2> &point, const unsigned int d)
      {
        vtkAxis     &axis  = d == 0 ? x() : y();
        const double share = (point[d] - axis.GetMinimum()) /
                             (axis.GetMaximum() - axis.GetMinimum());
        return axis.GetPoint1()[d] +
               share * (axis.GetPoint2()[d] - axis.GetPoint1()[d]);
      }

      vtkNew<vtkXMLDataElement>     root, definitions, page;
      vtkNew<vtkRenderer>           renderer;
      vtkNew<vtkRenderWindow>       window;
      vtkNew<vtkContextScene>       scene;
      vtkNew<vtkChartXY>            chart;
      vtkNew<vtkSVGContextDevice2D> device;
      vtkNew<vtkContext2D>          context;
    };
  } // namespace



  std::string
  plot(const ConvergenceResults &results)
  {
    const Extrapolation limit = results.extrapolated();
    Plot                plot("On cells of size zero: " + to_text(limit),
              "Size of the cells at the outlet's lip (m)",
              "Flow rate (kg/s)");

    std::vector<std::array<double, 2>> dots;
    double                             largest = 0.;
    for (const ConvergenceRow &row : results.rows())
      {
        dots.push_back({{row.run.resolution.smallest_size(), row.flow_rate}});
        largest = std::max(largest, dots.back()[0]);
      }
    const std::array<double, 2> line_end = {
      {largest, limit.value + limit.slope * largest}};
    const std::array<double, 2> lowest = {
      {0., limit.value - limit.uncertainty}};
    const std::array<double, 2> highest = {
      {0., limit.value + limit.uncertainty}};

    auto all = dots;
    for (const auto &point : {line_end, lowest, highest})
      all.push_back(point);
    plot.draw_axes(all);
    plot.draw_line({{0., limit.value}}, line_end, colour_of_limit);
    plot.draw_line(lowest, highest, colour_of_limit);
    plot.draw_dot({{0., limit.value}}, colour_of_limit);
    for (const auto &dot : dots)
      plot.draw_dot(dot, colour_of_runs);
    return plot.text();
  }
} // namespace Sandglass
