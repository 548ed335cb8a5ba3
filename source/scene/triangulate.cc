#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/reference_cell.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/scene/triangulate.h>

#include <map>
#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    std::vector<CellData<dim>>
    make_cells(const Mesh &mesh)
    {
      std::vector<CellData<dim>> cells;
      cells.reserve(mesh.cells.size());
      for (const auto &cell : mesh.cells)
        {
          CellData<dim> data(mesh.vertices_per_cell());
          for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
            data.vertices[v] = cell.vertices[v];
          // deal.II numbers a quadrilateral's vertices line by line
          if (mesh.cell_type == CellType::quadrilateral)
            std::swap(data.vertices[2], data.vertices[3]);
          cells.push_back(data);
        }
      return cells;
    }



    /// The boundary edges with their ids. Inner edges with a role (the outlet
    /// above a fall region) cannot carry one.
    SubCellData
    make_boundary_lines(const Mesh &mesh)
    {
      using Edge        = std::pair<unsigned int, unsigned int>;
      const auto sorted = [](const unsigned int a, const unsigned int b) {
        return Edge(std::min(a, b), std::max(a, b));
      };

      std::map<Edge, unsigned int> n_cells_at;
      const unsigned int           n_vertices = mesh.vertices_per_cell();
      for (const auto &cell : mesh.cells)
        for (unsigned int v = 0; v < n_vertices; ++v)
          ++n_cells_at[sorted(cell.vertices[v],
                              cell.vertices[(v + 1) % n_vertices])];

      SubCellData result;
      for (const auto &edge : mesh.edges)
        {
          const auto entry =
            n_cells_at.find(sorted(edge.vertices[0], edge.vertices[1]));
          if (entry == n_cells_at.end() || entry->second != 1)
            continue;
          CellData<1> line;
          line.vertices    = {edge.vertices[0], edge.vertices[1]};
          line.boundary_id = boundary_id(edge.role);
          result.boundary_lines.push_back(line);
        }
      return result;
    }



    void
    check_boundary(const Triangulation<dim> &triangulation)
    {
      for (const auto &face : triangulation.active_face_iterators())
        if (face->at_boundary() &&
            (face->boundary_id() < 1 ||
             face->boundary_id() > boundary_role_names.size()))
          {
            std::ostringstream message;
            message << "The mesh's boundary edge at (" << face->center()
                    << ") m has no name. Allowed are physical groups of lines "
                       "that together cover the boundary, named";
            for (const auto &name : boundary_role_names)
              message << ' ' << name;
            throw InputError(message.str());
          }
    }
  } // namespace



  void
  triangulate(const Mesh &mesh, Triangulation<dim> &triangulation)
  {
    std::vector<CellData<dim>> cells = make_cells(mesh);

    const SubCellData subcell_data = make_boundary_lines(mesh);
    GridTools::invert_all_negative_measure_cells(mesh.vertices, cells);
    if (mesh.cell_type == CellType::quadrilateral)
      GridTools::consistently_order_cells(cells);
    triangulation.create_triangulation(mesh.vertices, cells, subcell_data);
    check_boundary(triangulation);
  }
} // namespace Sandglass
