#include <sandglass/report/wall_cut.h>

#include <vtkCell.h>

#include <sstream>

namespace Sandglass
{
  namespace Report
  {
    std::string
    wall_cut(vtkUnstructuredGrid &walls)
    {
      // A little beside the plane: the walls may end there, at a symmetry
      // plane, or have their faces' edges there.
      const double       height = 1e-6 * walls.GetLength();
      std::ostringstream pieces;
      pieces.precision(6);
      const char *separator = "";
      for (vtkIdType c = 0; c < walls.GetNumberOfCells(); ++c)
        {
          vtkCell *const     face   = walls.GetCell(c);
          const int          n      = face->GetNumberOfPoints();
          unsigned int       n_ends = 0;
          std::ostringstream ends;
          ends.precision(6);
          for (int i = 0; i < n; ++i)
            {
              double a[3], b[3];
              walls.GetPoint(face->GetPointId(i), a);
              walls.GetPoint(face->GetPointId((i + 1) % n), b);
              if ((a[2] < height) == (b[2] < height))
                continue;
              const double share = (height - a[2]) / (b[2] - a[2]);
              ends << (n_ends == 0 ? "[" : ",[") << a[0] + share * (b[0] - a[0])
                   << ',' << a[1] + share * (b[1] - a[1]) << ']';
              ++n_ends;
            }
          if (n_ends != 2)
            continue;
          pieces << separator << '[' << ends.str() << ']';
          separator = ",";
        }
      return '[' + pieces.str() + ']';
    }
  } // namespace Report
} // namespace Sandglass
