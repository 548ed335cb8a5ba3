#include <deal.II/base/exceptions.h>

#include <sandglass/flow/updated_lagrangian/rezoning/nodal_transfer.h>
#include <sandglass/flow/updated_lagrangian/rezoning/triangle_element.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    /// Keep values outside of a cell within its nodes' bounds, widened by so
    /// much of their distance that linear fields are continued for a tenth of
    /// the cell: a quadratic one may be wild there.
    void
    limit(const TriangleMesh &mesh,
          const MeshField    &field,
          const unsigned int  cell,
          double             *values)
    {
      constexpr double margin = 0.25;
      for (unsigned int c = 0; c < field.n_components; ++c)
        {
          double lower = field.at(mesh.cells[cell][0])[c], upper = lower;
          for (unsigned int i = 1; i < mesh.n_nodes_per_cell(); ++i)
            {
              const double value = field.at(mesh.cells[cell][i])[c];
              lower              = std::min(lower, value);
              upper              = std::max(upper, value);
            }
          const double more = margin * (upper - lower);
          values[c]         = std::clamp(values[c], lower - more, upper + more);
        }
    }
  } // namespace



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



  MeshField
  transfer_nodal_field(const TriangleMesh          &old_mesh,
                       const MeshField             &field,
                       const std::vector<Location> &locations)
  {
    AssertDimension(field.values.size(),
                    field.n_components * old_mesh.nodes.size());
    MeshField result = MeshField::zero(field.n_components, locations.size());
    for (std::size_t n = 0; n < locations.size(); ++n)
      {
        evaluate_in_cell(old_mesh,
                         field,
                         locations[n].cell,
                         locations[n].reference_point,
                         result.at(n));
        if (locations[n].smallest_coordinate < 0.)
          limit(old_mesh, field, locations[n].cell, result.at(n));
      }
    return result;
  }
} // namespace Sandglass
