#include <deal.II/base/exceptions.h>

#include <sandglass/flow/updated_lagrangian/rezoning/nodal_transfer.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>

namespace Sandglass
{
  std::vector<Location>
  locate_nodes(const PointLocator &locator, const TriangleMesh &new_mesh)
  {
    std::vector<Location> locations(new_mesh.nodes.size());
    const auto            bodies = bodies_of_nodes(new_mesh);
    for (unsigned int node = 0; node < bodies.size(); ++node)
      if (bodies[node] != numbers::invalid_unsigned_int)
        locations[node] = locator.find(new_mesh.nodes[node], bodies[node]);
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
      evaluate_in_cell(old_mesh,
                       field,
                       locations[n].cell,
                       locations[n].reference_point,
                       result.at(n));
    return result;
  }
} // namespace Sandglass
