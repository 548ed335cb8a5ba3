#include <deal.II/grid/grid_tools.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/choices/dimensions.h>
#include <sandglass/scene/mesh_faces.h>
#include <sandglass/scene/triangulate.h>

#include <algorithm>
#include <sstream>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::vector<CellData<dim>>
    make_cells(const Mesh<dim> &mesh)
    {
      std::vector<CellData<dim>> cells;
      cells.reserve(mesh.cells.size());
      for (const auto &cell : mesh.cells)
        {
          CellData<dim> data(mesh.vertices_per_cell());
          for (unsigned int v = 0; v < mesh.vertices_per_cell(); ++v)
            data.vertices[v] = cell.vertices[v];
          // deal.II numbers the vertices of cubes line by line.
          if (!is_simplex(mesh.cell_type))
            for (unsigned int v = 2; v < data.vertices.size(); v += 4)
              std::swap(data.vertices[v], data.vertices[v + 1]);
          cells.push_back(data);
        }
      return cells;
    }



    /// The boundary faces with their ids. Inner faces with a role (the outlet
    /// above a fall region) cannot carry one.
    template <int dim>
    SubCellData
    make_boundary_faces(const Mesh<dim> &mesh)
    {
      const CellsAtFaces<dim> cells_at = cells_at_faces(mesh);
      const unsigned int      n        = mesh.vertices_per_face();
      SubCellData             result;
      for (const auto &face : mesh.faces)
        {
          const auto entry = cells_at.find(key_of<dim>(face.vertices, n));
          if (entry == cells_at.end() || entry->second.size() != 1)
            continue;
          CellData<dim - 1> data(n);
          data.vertices.assign(face.vertices.begin(),
                               face.vertices.begin() + n);
          data.boundary_id = face.boundary_id();
          if constexpr (dim == 2)
            result.boundary_lines.push_back(data);
          else
            result.boundary_quads.push_back(data);
        }
      return result;
    }



    template <int dim>
    void
    check_boundary(const Triangulation<dim> &triangulation)
    {
      for (const auto &face : triangulation.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == 0)
          {
            std::ostringstream message;
            message << "The mesh's boundary edge at (" << face->center()
                    << ") m has no name. Allowed are physical groups of lines "
                       "that together cover the boundary, named";
            for (const auto &name : boundary_role_names)
              message << ' ' << name;
            message << ", or as Walls/Friction angles names further walls.";
            throw InputError(message.str());
          }
    }
  } // namespace



  template <int dim>
  void
  triangulate(const Mesh<dim> &mesh, Triangulation<dim> &triangulation)
  {
    std::vector<CellData<dim>> cells = make_cells(mesh);

    const SubCellData subcell_data = make_boundary_faces(mesh);
    GridTools::invert_all_negative_measure_cells(mesh.vertices, cells);
    if (!is_simplex(mesh.cell_type))
      GridTools::consistently_order_cells(cells);
    triangulation.create_triangulation(mesh.vertices, cells, subcell_data);
    check_boundary(triangulation);
  }



#define INSTANTIATE(dim)                            \
  template void triangulate<dim>(const Mesh<dim> &, \
                                 dealii::Triangulation<dim> &);

  SANDGLASS_FOR_EACH_DIMENSION(INSTANTIATE)
} // namespace Sandglass
