#include "run_output.h"

#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLGenericDataObjectReader.h>
#include <vtkXMLUtilities.h>

#include <filesystem>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace Figures
{
  namespace
  {
    void
    check_file(const std::string &filename)
    {
      if (!std::filesystem::is_regular_file(filename))
        throw std::runtime_error("There is no file '" + filename + "'.");
    }
  } // namespace



  Series
  read_series(const std::string &directory, const std::string &name)
  {
    if (!std::filesystem::is_directory(directory))
      throw std::runtime_error("There is no directory '" + directory + "'.");
    const std::string filename = directory + '/' + name + ".pvd";
    check_file(filename);

    Series     series;
    const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromFile(filename.c_str()));
    auto *const list =
      root ? root->FindNestedElementWithName("Collection") : nullptr;
    for (int i = 0; list && i < list->GetNumberOfNestedElements(); ++i)
      {
        auto *const       entry = list->GetNestedElement(i);
        const char *const file  = entry->GetAttribute("file");
        double            time;
        if (file && entry->GetScalarAttribute("timestep", time))
          series[time] = directory + '/' + file;
      }
    if (series.empty())
      throw std::runtime_error("'" + filename + "' lists no files.");
    return series;
  }



  Series::const_iterator
  find_nearest(const Series &series, const double time)
  {
    const double first = series.begin()->first, last = series.rbegin()->first;
    // Output waits for the end of a time step, so `time` may be a bit outside.
    const double tolerance = .1 * (last - first) / series.size();
    if (!(time >= first - tolerance && time <= last + tolerance))
      {
        std::ostringstream message;
        message << "There is no time " << time << " s: the output goes from "
                << first << " s to " << last << " s.";
        throw std::runtime_error(message.str());
      }
    const auto next = series.lower_bound(time);
    if (next == series.begin())
      return next;
    const auto previous = std::prev(next);
    return next == series.end() || time - previous->first < next->first - time ?
             previous :
             next;
  }



  vtkSmartPointer<vtkUnstructuredGrid>
  read_grid(const std::string &filename)
  {
    check_file(filename);
    vtkNew<vtkXMLGenericDataObjectReader> reader;
    reader->SetFileName(filename.c_str());
    reader->Update();
    auto *const grid = reader->GetUnstructuredGridOutput();
    if (!grid || grid->GetNumberOfPoints() == 0)
      throw std::runtime_error("'" + filename + "' is empty or can't be read.");
    return grid;
  }



  std::vector<double>
  field_values(vtkUnstructuredGrid &grid, const std::string &field)
  {
    const std::size_t colon = field.find(':');
    const std::string name =
      field == "speed" ? "velocity" : field.substr(0, colon);
    vtkDataArray *const array = grid.GetPointData()->GetArray(name.c_str());
    if (!array)
      throw std::runtime_error("The particles have no field '" + name + "'.");

    const int n_components = array->GetNumberOfComponents();
    int       component    = n_components; // none: the magnitude
    for (int c = 0; c < n_components; ++c)
      if (n_components == 1 ||
          (array->GetComponentName(c) &&
           name + ':' + array->GetComponentName(c) == field))
        component = c;
    if (component == n_components && colon != std::string::npos)
      throw std::runtime_error("There is no component '" + field + "'.");

    std::vector<double> values;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      values.push_back(component < n_components ?
                         array->GetComponent(i, component) :
                         vtkMath::Norm(array->GetTuple(i), n_components));
    return values;
  }
} // namespace Figures
