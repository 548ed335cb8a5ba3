#ifndef sandglass_figures_run_output_h
#define sandglass_figures_run_output_h

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <map>
#include <string>
#include <vector>

namespace Figures
{
  /// Times in s, and the files with the fields at these times.
  using Series = std::map<double, std::string>;

  /// What `directory`/`name`.pvd lists. Like all functions here it throws
  /// std::runtime_error if something is missing.
  Series
  read_series(const std::string &directory, const std::string &name);

  /// The entry next to a time.
  Series::const_iterator
  find_nearest(const Series &series, const double time);

  vtkSmartPointer<vtkUnstructuredGrid>
  read_grid(const std::string &filename);

  /// A field at the particles: its magnitude or, as in `stress:YY`, one
  /// component. `speed` is the velocity's magnitude.
  std::vector<double>
  field_values(vtkUnstructuredGrid &grid, const std::string &field);
} // namespace Figures

#endif
