#ifndef sandglass_report_wall_cut_h
#define sandglass_report_wall_cut_h

#include <vtkUnstructuredGrid.h>

#include <string>

namespace Sandglass
{
  namespace Report
  {
    /**
     * Where the walls of a silo in three dimensions meet the plane z = 0, in
     * JSON: a list of pieces, each [[x, y], [x, y]] (m).
     */
    std::string
    wall_cut(vtkUnstructuredGrid &walls);
  } // namespace Report
} // namespace Sandglass

#endif
