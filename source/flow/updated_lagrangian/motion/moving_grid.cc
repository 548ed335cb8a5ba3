#include <sandglass/flow/updated_lagrangian/motion/moving_grid.h>

namespace Sandglass
{
  namespace
  {
    /// The corners and cells of a mesh; its boundary is nobody's wall.
    Mesh<2>
    straight_mesh(const TriangleMesh &mesh)
    {
      Mesh<2>                   result;
      std::vector<unsigned int> vertex_of(mesh.nodes.size(),
                                          numbers::invalid_unsigned_int);
      result.cell_type = CellType::triangle;
      for (const auto &nodes : mesh.cells)
        {
          Mesh<2>::Cell cell{};
          cell.is_filled = true;
          for (unsigned int v = 0; v < 3; ++v)
            {
              unsigned int &vertex = vertex_of[nodes[v]];
              if (vertex == numbers::invalid_unsigned_int)
                {
                  vertex = result.vertices.size();
                  result.vertices.push_back(mesh.nodes[nodes[v]]);
                }
              cell.vertices[v] = vertex;
            }
          result.cells.push_back(cell);
        }
      for (const auto &edge : mesh.boundary)
        {
          const auto &nodes = mesh.cells[edge.cell];
          result.faces.push_back({{{vertex_of[nodes[edge.edge]],
                                    vertex_of[nodes[(edge.edge + 1) % 3]]}},
                                  BoundaryRole::top});
        }
      return result;
    }
  } // namespace



  MovingGrid::MovingGrid(const TriangleMesh &mesh)
    : mesh(mesh)
    , elements(straight_mesh(mesh),
               mesh.order,
               MPI_COMM_SELF,
               [](const unsigned int) { return 0; })
    , dof_of_node(mesh.nodes.size(), numbers::invalid_unsigned_int)
    , straight(mesh.nodes)
    , bulge_of_edges(elements.make_vector())
  {
    AssertDimension(elements.local_cells.size(), mesh.cells.size());
    for (unsigned int c = 0; c < mesh.cells.size(); ++c)
      {
        const auto &nodes = mesh.cells[c];
        for (unsigned int i = 0; i < mesh.n_nodes_per_cell(); ++i)
          dof_of_node[nodes[i]] = elements.local_cells[c].dofs[2 * i];
        for (unsigned int i = 3; i < mesh.n_nodes_per_cell(); ++i)
          straight[nodes[i]] =
            mesh.nodes[nodes[i - 3]] +
            (mesh.nodes[nodes[(i - 2) % 3]] - mesh.nodes[nodes[i - 3]]) / 2.;
        Assert(elements.local_cells[c].cell->vertex(0).distance(
                 mesh.nodes[nodes[0]]) == 0. &&
                 elements.local_cells[c].cell->vertex(1).distance(
                   mesh.nodes[nodes[1]]) == 0.,
               ExcInternalError());
      }
    MeshField bulge = MeshField::zero(2, mesh.nodes.size());
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      for (unsigned int d = 0; d < 2; ++d)
        bulge.at(n)[d] = mesh.nodes[n][d] - straight[n][d];
    bulge_of_edges = vector_of(bulge);
  }



  TriangleMesh
  MovingGrid::displaced(const Vector &displacement) const
  {
    TriangleMesh result = mesh;
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      for (unsigned int d = 0; d < 2; ++d)
        result.nodes[n][d] =
          straight[n][d] + displacement.local_element(dof_of_node[n] + d);
    return result;
  }



  DisplacementVector
  MovingGrid::vector_of(const MeshField &field) const
  {
    AssertDimension(field.n_components, 2);
    Vector vector = elements.make_vector();
    vector.zero_out_ghost_values();
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      for (unsigned int d = 0; d < 2; ++d)
        vector.local_element(dof_of_node[n] + d) = field.at(n)[d];
    vector.update_ghost_values();
    return vector;
  }



  MeshField
  MovingGrid::field_of(const Vector &vector) const
  {
    MeshField field = MeshField::zero(2, mesh.nodes.size());
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      for (unsigned int d = 0; d < 2; ++d)
        field.at(n)[d] = vector.local_element(dof_of_node[n] + d);
    return field;
  }
} // namespace Sandglass
