#include <sandglass/flow/updated_lagrangian/motion/check_new_mesh.h>
#include <sandglass/flow/updated_lagrangian/motion/mesh_walls.h>
#include <sandglass/flow/updated_lagrangian/motion/rezone_material.h>
#include <sandglass/flow/updated_lagrangian/motion/rezoning_options.h>
#include <sandglass/flow/updated_lagrangian/rezoning/cut_off.h>

#include <numeric>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// A body smaller than this share of an element can't be meshed.
    constexpr double smallest_body = 0.3;



    std::vector<double>
    body_masses_of(const TriangleMesh        &mesh,
                   const std::vector<double> &cell_masses)
    {
      std::vector<double> masses(mesh.n_bodies(), 0.);
      for (unsigned int cell = 0; cell < cell_masses.size(); ++cell)
        masses[mesh.bodies[cell]] += cell_masses[cell];
      return masses;
    }



    RezonedMaterial
    try_rezoning(const MotionSetting     &setting,
                 const MaterialState     &state,
                 const std::vector<bool> &is_spoilt)
    {
      const RezoningOptions options = rezoning_options(setting, state.at.mesh);
      const unsigned int    n_cells = state.at.mesh.cells.size();
      const auto cell_masses        = sums_by_cell(state.point_masses, n_cells);

      CutOff          cut = cut_off(state.at.mesh,
                           cell_masses,
                           setting.lowest_level,
                           options.size,
                           smallest_body,
                           is_spoilt);
      RezonedMaterial result;
      result.mass_below   = cut.mass_below;
      result.mass_slivers = cut.mass_slivers;
      std::ostringstream text;
      if (cut.is_cut())
        text << cut.n_cells_below << " elements cut off, " << cut.n_cells_sliver
             << " in slivers, " << cut.n_cells_spoilt << " folded; ";
      if (cut.mesh.cells.empty())
        {
          result.mass_slivers += cut.mass_spoilt;
          result.description = text.str() + "nothing is left";
          return result;
        }

      MeshState rest;
      rest.mesh = cut.mesh;
      mark_walls(rest.mesh, setting);
      check_crossings(rest.mesh, options);
      const unsigned int n_points = options.quadrature.size();
      rest.velocity               = state.at.velocity.at_blocks(cut.nodes);
      rest.nodal_fields           = state.at.nodal_fields.at_blocks(cut.nodes);
      rest.density =
        MeshField{1, state.at.density}.at_blocks(cut.cells, n_points).values;
      rest.point_fields = state.at.point_fields.at_blocks(cut.cells, n_points);
      std::vector<double> masses_left;
      for (const unsigned int cell : cut.cells)
        masses_left.push_back(cell_masses[cell]);
      auto body_masses = body_masses_of(rest.mesh, masses_left);
      // What was in folded elements goes to the others.
      const double kept =
        std::accumulate(body_masses.begin(), body_masses.end(), 0.);
      for (double &mass : body_masses)
        mass *= 1. + cut.mass_spoilt / kept;

      Rezoned rezoned = rezone(rest, options);
      check_area(rezoned.jumps, setting.element_size);
      result.state.at    = std::move(rezoned.state);
      TriangleMesh &mesh = result.state.at.mesh;
      snap_to_walls(mesh, setting);
      check_cells(mesh);
      result.state.point_masses = point_masses_of(mesh,
                                                  setting.depth,
                                                  result.state.at.density,
                                                  body_masses);
      result.description        = text.str() + rezoned.jumps.description();
      return result;
    }
  } // namespace



  RezonedMaterial
  rezone_material(const MotionSetting &setting, const MaterialState &state)
  {
    constexpr unsigned int most_tries = 6;

    TriangleMesh mesh = state.at.mesh;
    mark_walls(mesh, setting);
    std::vector<bool> is_spoilt(mesh.cells.size(), false);
    for (unsigned int i = 1; i < most_tries; ++i)
      try
        {
          return try_rezoning(setting, state, is_spoilt);
        }
      // The surface has folded. Without the elements that have, the body keeps
      // all but their shape.
      catch (const Crossing &crossing)
        {
          spoil_round(mesh,
                      crossing.place,
                      0.25 * i * setting.element_size,
                      is_spoilt);
        }
      catch (const RunError &)
        {
          spoil_distorted(mesh, 0.05 * i, is_spoilt);
        }
    return try_rezoning(setting, state, is_spoilt);
  }
} // namespace Sandglass
