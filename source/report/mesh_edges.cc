#include <sandglass/report/mesh_edges.h>

#include <vtkCell.h>

#include <cmath>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace Sandglass
{
  namespace Report
  {
    namespace
    {
      using Place = std::pair<double, double>;
      using Edge  = std::pair<unsigned int, unsigned int>;

      /// Cells may have vertices of their own at the same places: equal places
      /// are one vertex.
      struct Edges
      {
        std::vector<Place>           places;
        std::map<Edge, unsigned int> n_cells; // of each edge
      };



      Edges
      find_edges(vtkUnstructuredGrid &mesh)
      {
        Edges                         result;
        std::map<Place, unsigned int> numbers;
        std::vector<unsigned int>     vertices;
        for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i)
          {
            const double *const x = mesh.GetPoint(i);
            const auto [entry, is_new] =
              numbers.emplace(Place(x[0], x[1]), result.places.size());
            if (is_new)
              result.places.push_back(entry->first);
            vertices.push_back(entry->second);
          }
        const auto add = [&](vtkCell &cell) {
          for (int e = 0; e < cell.GetNumberOfEdges(); ++e)
            {
              vtkCell *const edge = cell.GetEdge(e);
              Edge           ends(vertices[edge->GetPointId(0)],
                        vertices[edge->GetPointId(1)]);
              if (ends.first > ends.second)
                std::swap(ends.first, ends.second);
              ++result.n_cells[ends];
            }
        };
        const double rounding = 1e-9 * mesh.GetLength();
        for (vtkIdType c = 0; c < mesh.GetNumberOfCells(); ++c)
          {
            vtkCell *const cell = mesh.GetCell(c);
            if (cell->GetCellDimension() < 3)
              add(*cell);
            for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
              {
                vtkCell *const face = cell->GetFace(f);
                double         bounds[6];
                face->GetBounds(bounds);
                if (std::abs(bounds[4]) < rounding &&
                    std::abs(bounds[5]) < rounding)
                  add(*face);
              }
          }
        return result;
      }
    } // namespace



    std::string
    mesh_edges(vtkUnstructuredGrid &mesh)
    {
      const Edges        edges = find_edges(mesh);
      std::ostringstream x, y, all, boundary;
      const char        *separator = "";
      for (const Place &place : edges.places)
        {
          x << separator << place.first;
          y << separator << place.second;
          separator = ",";
        }
      for (const auto &[edge, n_cells] : edges.n_cells)
        {
          const auto add = [&edge = edge](std::ostringstream &list) {
            list << (list.tellp() > 0 ? "," : "") << edge.first << ','
                 << edge.second;
          };
          add(all);
          if (n_cells == 1)
            add(boundary);
        }
      return "{\"x\": [" + x.str() + "], \"y\": [" + y.str() +
             "], \"edges\": [" + all.str() + "], \"boundary\": [" +
             boundary.str() + "]}";
    }
  } // namespace Report
} // namespace Sandglass
