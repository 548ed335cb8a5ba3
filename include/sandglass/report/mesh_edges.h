#ifndef sandglass_report_mesh_edges_h
#define sandglass_report_mesh_edges_h

#include <vtkUnstructuredGrid.h>

#include <string>

namespace Sandglass
{
  namespace Report
  {
    /**
     * The edges of a plane mesh in JSON: `x` and `y` (m) of the vertices,
     * `edges` as pairs of vertices, and `boundary`, those of one cell only. Of
     * a mesh in three dimensions the faces in the plane z = 0 are the cells.
     */
    std::string
    mesh_edges(vtkUnstructuredGrid &mesh);
  } // namespace Report
} // namespace Sandglass

#endif
