// What others see of the flow by finite elements, and its checkpoints.

#include <sandglass/flow/in_space.h>
#include <sandglass/flow/updated_lagrangian/motion/rezoning_options.h>
#include <sandglass/flow/updated_lagrangian/motion/updated_lagrangian_flow.h>
#include <sandglass/material/chosen_law.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <limits>

namespace Sandglass
{
  namespace
  {
    /// Share of a cell's area above the outlet level y = 0: that of the
    /// centres of small equal triangles of the reference cell.
    double
    share_above_outlet(const TriangleMesh &mesh, const unsigned int cell)
    {
      constexpr unsigned int n = 24;

      bool all_above = true, all_below = true;
      for (unsigned int i = 0; i < mesh.n_nodes_per_cell(); ++i)
        {
          const double y = mesh.nodes[mesh.cells[cell][i]][1];
          all_above      = all_above && y >= 0.;
          all_below      = all_below && y < 0.;
        }
      if (all_above || all_below)
        return all_above ? 1. : 0.;
      unsigned int n_above = 0;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; i + j < n; ++j)
          for (unsigned int upper = 0; upper < (i + j + 1 < n ? 2 : 1); ++upper)
            {
              const double shift = upper == 1 ? 2. / 3. : 1. / 3.;
              n_above += position_in_cell(mesh,
                                          cell,
                                          Point<2>((i + shift) / n,
                                                   (j + shift) / n))[1] >= 0.;
            }
      return static_cast<double>(n_above) / (n * n);
    }
  } // namespace



  FlowTotals
  UpdatedLagrangianFlow::totals() const
  {
    FlowTotals totals;
    totals.mass_removed         = mass_removed;
    totals.mass_lost            = mass_lost;
    totals.dissipated_energy    = dissipated_before + friction_dissipation;
    totals.dissipation_can_fall = dissipation_can_fall(setting.material);
    if (!body)
      return totals;

    const TriangleMesh mesh   = body->mesh();
    const auto         masses = body->cell_masses();
    for (unsigned int cell = 0; cell < masses.size(); ++cell)
      {
        const double share = share_above_outlet(mesh, cell);
        totals.mass_in_silo += share * masses[cell];
        totals.mass_falling += (1. - share) * masses[cell];
      }
    totals.n_particles    = masses.size() * body->n_points_per_cell();
    totals.particle_steps = totals.n_particles * time.step;

    const auto energies   = body->motion.energies();
    totals.kinetic_energy = energies.kinetic;
    totals.elastic_energy = energies.elastic;
    totals.dissipated_energy += energies.dissipated;

    DisplacementVector momentum = body->grid.elements.make_vector();
    momentum.zero_out_ghost_values();
    body->consistent_mass.add_forces(body->motion.velocity(), momentum);
    const MeshField nodal    = body->grid.field_of(momentum);
    const MeshField velocity = body->grid.field_of(body->motion.velocity());
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      {
        for (unsigned int d = 0; d < 2; ++d)
          totals.momentum[d] += nodal.at(n)[d];
        totals.largest_speed =
          std::max(totals.largest_speed,
                   std::hypot(velocity.at(n)[0], velocity.at(n)[1]));
      }
    return totals;
  }



  double
  UpdatedLagrangianFlow::critical_time_step(const bool) const
  {
    return std::numeric_limits<double>::infinity();
  }



  WallArea
  UpdatedLagrangianFlow::wall_area() const
  {
    WallArea area{0., 0.};
    if (body && is_first_rank)
      for (const NodeContact &contact : body->contact.contacts())
        if (!setting.walls[contact.wall].is_axis() && contact.normal_force > 0.)
          {
            area.touching += contact.area;
            if (contact.is_sliding)
              area.sliding += contact.area;
          }
    return area;
  }



  WallRecords
  UpdatedLagrangianFlow::wall_records() const
  {
    WallRecords result;
    result.time = time.time;
    if (is_first_rank)
      result.records = walls.records();
    return result;
  }



  std::vector<StateVariable>
  UpdatedLagrangianFlow::state_variables() const
  {
    return state_variables_of_law(setting.material);
  }



  unsigned int
  UpdatedLagrangianFlow::n_particles() const
  {
    return body && is_first_rank ?
             body->grid.mesh.cells.size() * body->n_points_per_cell() :
             0;
  }



  void
  UpdatedLagrangianFlow::for_each_particle(
    const std::function<void(const ParticleRecord &)> &function) const
  {
    if (!body || !is_first_rank)
      return;
    const MaterialState state      = body->state();
    const MeshState    &at         = state.at;
    const Quadrature<2> quadrature = stress_quadrature(at.mesh.order);
    const auto          masses     = body->cell_masses();
    for (unsigned int i = 0; i < at.density.size(); ++i)
      {
        const unsigned int cell  = i / quadrature.size();
        const Point<2>    &place = quadrature.point(i % quadrature.size());
        double             velocity[2], fields[4];
        evaluate_in_cell(at.mesh, at.velocity, cell, place, velocity);
        evaluate_in_cell(at.mesh, at.nodal_fields, cell, place, fields);
        const Point<2> location = position_in_cell(at.mesh, cell, place);

        ParticleRecord record;
        record.id       = i;
        record.location = in_space(location);
        record.initial_location =
          in_space(Point<2>(location[0] - fields[2], location[1] - fields[3]));
        record.velocity = Tensor<1, 3>({velocity[0], velocity[1], 0.});
        record.stress.fill(0.);
        const double *values = at.point_fields.at(i);
        std::copy_n(values, 4, record.stress.begin());
        record.mass      = masses[cell] / quadrature.size();
        record.density   = at.density[i];
        record.law_state = values + 4;
        function(record);
      }
  }



  GridRecords
  UpdatedLagrangianFlow::grid() const
  {
    GridRecords result;
    result.nodes_per_cell = 3 * setting.parameters.element_order;
    if (!body || !is_first_rank)
      return result;
    const TriangleMesh  mesh     = body->mesh();
    const MeshField     velocity = body->grid.field_of(body->motion.velocity());
    std::vector<double> masses(mesh.nodes.size(), 0.);
    const auto          of_cells = body->cell_masses();
    for (unsigned int cell = 0; cell < mesh.cells.size(); ++cell)
      {
        for (unsigned int i = 0; i < mesh.n_nodes_per_cell(); ++i)
          {
            result.nodes_of_cells.push_back(mesh.cells[cell][i]);
            // The consistent matrix' rows: a third at each edge or corner.
            if (mesh.order == 1 || i >= 3)
              masses[mesh.cells[cell][i]] += of_cells[cell] / 3.;
          }
        result.cells.push_back({body->n_points_per_cell(), 0});
      }
    for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
      result.nodes.push_back(
        {in_space(mesh.nodes[n]),
         masses[n],
         Tensor<1, 3>({velocity.at(n)[0], velocity.at(n)[1], 0.})});
    return result;
  }



  namespace
  {
    template <class Archive>
    void
    serialize_mesh(Archive &archive, TriangleMesh &mesh)
    {
      archive &mesh.order &mesh.nodes &mesh.bodies;
      auto     n = static_cast<unsigned int>(mesh.cells.size());
      archive &n;
      mesh.cells.resize(n);
      for (auto &cell : mesh.cells)
        archive &cell;
      n = mesh.boundary.size();
      archive &n;
      mesh.boundary.resize(n);
      for (auto &edge : mesh.boundary)
        archive &edge.cell &edge.edge &edge.mark;
    }
  } // namespace



  void
  UpdatedLagrangianFlow::save(boost::archive::binary_oarchive &archive) const
  {
    const bool has_body = body != nullptr;
    archive << time << walls << rezonings << quality_of_new_mesh << mass_removed
            << mass_lost << dissipated_before << friction_dissipation
            << has_body;
    if (!body)
      return;
    TriangleMesh mesh = body->grid.mesh;
    serialize_mesh(archive, mesh);
    archive << body->point_masses;
    body->save(archive);
  }



  void
  UpdatedLagrangianFlow::load(boost::archive::binary_iarchive &archive)
  {
    bool has_body;
    archive >> time >> walls >> rezonings >> quality_of_new_mesh >>
      mass_removed >> mass_lost >> dissipated_before >> friction_dissipation >>
      has_body;
    body.reset();
    if (!has_body)
      return;
    // A state of this mesh with nothing in it, which is then filled.
    MaterialState state;
    serialize_mesh(archive, state.at.mesh);
    archive >> state.point_masses;
    const unsigned int n_points = state.at.mesh.cells.size() *
                                  stress_quadrature(state.at.mesh.order).size();
    unsigned int n_law_values = 0;
    for (const StateVariable &variable : state_variables())
      n_law_values += variable.n_components;
    state.at.velocity     = MeshField::zero(2, state.at.mesh.nodes.size());
    state.at.nodal_fields = MeshField::zero(4, state.at.mesh.nodes.size());
    state.at.density.assign(n_points, setting.material.density);
    state.at.point_fields = MeshField::zero(4 + n_law_values, n_points);
    body                  = std::make_unique<MovingBody>(setting,
                                        state,
                                        time.time,
                                        setting.parameters.time_step);
    body->load(archive);
  }
} // namespace Sandglass
