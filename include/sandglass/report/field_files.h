#ifndef sandglass_report_field_files_h
#define sandglass_report_field_files_h

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <filesystem>
#include <string>
#include <vector>

namespace Sandglass
{
  namespace Report
  {
    /// One of the files that a .pvd file lists.
    struct FieldFile
    {
      double                time; // s
      std::filesystem::path file;
    };

    /**
     * The files that a .pvd file lists, in its order; none if there is no such
     * file. Throws InputError if it is damaged.
     */
    std::vector<FieldFile>
    read_pvd(const std::filesystem::path &file);

    /**
     * The points, cells and fields of a .vtu file or of the pieces of a .pvtu
     * file. Throws InputError if one is missing or damaged.
     */
    vtkSmartPointer<vtkUnstructuredGrid>
    read_fields(const std::filesystem::path &file);

    /**
     * A field at the points, with `n_components`. Throws InputError, with the
     * name of `file`, if there is no such field.
     */
    vtkDataArray &
    point_field(vtkUnstructuredGrid         &grid,
                const std::string           &name,
                const int                    n_components,
                const std::filesystem::path &file);

    /// The same of a field at the cells.
    vtkDataArray &
    cell_field(vtkUnstructuredGrid         &grid,
               const std::string           &name,
               const int                    n_components,
               const std::filesystem::path &file);
  } // namespace Report
} // namespace Sandglass

#endif
