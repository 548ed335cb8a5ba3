#include <deal.II/base/exceptions.h>

#include <sandglass/flow/updated_lagrangian/rezoning/nodal_transfer.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>

namespace Sandglass
{
  std::vector<Location>
  locate_nodes(const PointLocator &locator, const TriangleMesh &new_mesh)
  {
    std::vector<Location> locations(new_mesh.nodes.size());
    std::vector<bool>     is_located(new_mesh.nodes.size(), false);
    for (unsigned int cell = 0; cell < new_mesh.cells.size(); ++cell)
      for (unsigned int i = 0; i < new_mesh.n_nodes_per_cell(); ++i)
        {
          const unsigned int node = new_mesh.cells[cell][i];
          if (!is_located[node])
            locations[node] =
              locator.find(new_mesh.nodes[node], new_mesh.bodies[cell]);
          is_located[node] = true;
        }
    return locations;
  }



  Field
  transfer_nodal_field(const TriangleMesh          &old_mesh,
                       const Field                 &field,
                       const std::vector<Location> &locations)
  {
    AssertDimension(field.values.size(),
                    field.n_components * old_mesh.nodes.size());
    Field result = Field::zero(field.n_components, locations.size());
    for (std::size_t n = 0; n < locations.size(); ++n)
      {
        const auto shapes =
          shape_values(old_mesh.order, locations[n].reference_point);
        for (unsigned int i = 0; i < old_mesh.n_nodes_per_cell(); ++i)
          for (unsigned int c = 0; c < field.n_components; ++c)
            result.at(n)[c] +=
              shapes[i] * field.at(old_mesh.cells[locations[n].cell][i])[c];
      }
    return result;
  }
} // namespace Sandglass
