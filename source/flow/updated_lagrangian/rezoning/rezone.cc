#include <deal.II/base/exceptions.h>

#include <sandglass/flow/updated_lagrangian/rezoning/mesh_outlines.h>
#include <sandglass/flow/updated_lagrangian/rezoning/nodal_transfer.h>
#include <sandglass/flow/updated_lagrangian/rezoning/patch_recovery.h>
#include <sandglass/flow/updated_lagrangian/rezoning/point_locator.h>
#include <sandglass/flow/updated_lagrangian/rezoning/rezone.h>

#include <algorithm>

namespace Sandglass
{
  namespace
  {
    void
    map_nodal_fields(const MeshState    &old,
                     const PointLocator &locator,
                     Rezoned            &result)
    {
      const auto locations = locate_nodes(locator, result.state.mesh);
      result.state.velocity =
        transfer_nodal_field(old.mesh, old.velocity, locations);
      result.state.nodal_fields =
        transfer_nodal_field(old.mesh, old.nodal_fields, locations);
      for (const Location &location : locations)
        if (location.distance > 0.)
          {
            ++result.jumps.n_projected;
            result.jumps.farthest =
              std::max(result.jumps.farthest, location.distance);
          }
    }



    void
    map_point_fields(const MeshState       &old,
                     const RezoningOptions &options,
                     const PointLocator    &locator,
                     Rezoned               &result)
    {
      const auto locations =
        locate_points(locator, result.state.mesh, options.quadrature);
      const auto map = [&](const MeshField  &field,
                           const Admissible &admissible) {
        if (field.n_components == 0)
          return field;
        const PatchRecovery recovery(old.mesh,
                                     options.quadrature,
                                     field,
                                     options.margin);
        const auto          mapped = transfer_point_field(recovery,
                                                 field.n_components,
                                                 locations,
                                                 admissible);
        result.jumps.n_limited += mapped.n_limited;
        return mapped.field;
      };
      result.state.density = map({1, old.density}, [](const double *density) {
                               return *density > 0.;
                             }).values;
      result.state.point_fields = map(old.point_fields, options.is_admissible);
    }
  } // namespace



  Rezoned
  rezone(const MeshState &old, const RezoningOptions &options)
  {
    Assert(!old.mesh.cells.empty(), ExcMessage("There is no material."));
    Rezoned    result;
    MeshState &state = result.state;
    const auto new_mesh =
      mesh_outlines(find_outlines(old.mesh, options.corners),
                    options.size,
                    old.mesh.order);
    state.mesh = new_mesh.mesh;

    const PointLocator locator(old.mesh);
    map_nodal_fields(old, locator, result);
    map_point_fields(old, options, locator, result);

    const auto totals_of = [&options](const MeshState &s) {
      return body_totals(
        s.mesh, options.quadrature, options.depth, s.density, s.velocity);
    };
    const auto wanted   = totals_of(old);
    auto       actual   = totals_of(state);
    result.jumps.before = sum(wanted);
    result.jumps.mapped = sum(actual);
    restore_mass(state.mesh, wanted, actual, state.density);
    actual = totals_of(state);
    restore_momentum(
      state.mesh, wanted, actual, options.keeps_momentum, state.velocity);
    result.jumps.after = sum(totals_of(state));

    result.jumps.n_bodies       = wanted.size();
    result.jumps.n_cells        = state.mesh.cells.size();
    result.jumps.n_nodes        = state.mesh.nodes.size();
    result.jumps.n_straightened = new_mesh.n_straightened;
    return result;
  }
} // namespace Sandglass
