#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/flow/updated_lagrangian/motion/mesh_walls.h>
#include <sandglass/flow/updated_lagrangian/motion/rezone_material.h>
#include <sandglass/flow/updated_lagrangian/motion/rezoning_options.h>
#include <sandglass/flow/updated_lagrangian/motion/surface_at_walls.h>
#include <sandglass/flow/updated_lagrangian/motion/updated_lagrangian_flow.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Sandglass
{
  namespace
  {
    /// Where new elements are not good either, they are let alone until they
    /// are this share of what they were.
    constexpr double worn_out = 0.5;

    /// A step that has been halved so often is tried on a new mesh.
    constexpr unsigned int most_halvings = 3;
  } // namespace



  UpdatedLagrangianFlow::UpdatedLagrangianFlow(
    const Scene<2>                    &scene,
    const MaterialParameters          &material,
    const WallParameters              &walls,
    const UpdatedLagrangianParameters &parameters,
    const StaticStageParameters       &static_parameters,
    const double                      &end_time,
    ConditionalOStream                &log)
    : setting(scene, material, walls, parameters, static_parameters)
    , end_time(end_time)
    , log(log)
    , is_first_rank(Utilities::MPI::this_mpi_process(scene.communicator) == 0)
    , criterion(rezoning_criterion(setting))
    , walls(scene)
  {
    start_from(
      [](const unsigned int, const Point<2> &) {
        return InitialState<2>{{}, {}, 1.};
      },
      {});
  }



  TriangleMesh
  UpdatedLagrangianFlow::initial_mesh() const
  {
    const auto   part = filled_part(setting.scene.mesh);
    TriangleMesh mesh;
    mesh.order = setting.parameters.element_order;
    for (const Point<2> &vertex : part.mesh.vertices)
      mesh.nodes.push_back(vertex);
    for (const auto &cell : part.mesh.cells)
      {
        TriangleMesh::Cell nodes{};
        std::copy_n(cell.vertices.begin(), 3, nodes.begin());
        mesh.cells.push_back(nodes);
      }
    if (mesh.order == 2)
      add_edge_nodes(mesh);
    find_boundary(mesh, [](const unsigned int, const unsigned int) {
      return TriangleMesh::free_surface;
    });
    return mesh;
  }



  void
  UpdatedLagrangianFlow::start_from(
    const InitialStateFunction<2>   &initial_state,
    const std::vector<WallForce<2>> &wall_forces)
  {
    const auto    cells = filled_part(setting.scene.mesh).cells;
    MaterialState state;
    MeshState    &at = state.at;
    at.mesh          = initial_mesh();
    state.point_masses =
      even_point_masses(at.mesh, setting.depth, setting.material.density);

    const unsigned int n_nodes     = at.mesh.nodes.size();
    at.velocity                    = MeshField::zero(2, n_nodes);
    at.nodal_fields                = MeshField::zero(4, n_nodes);
    const Quadrature<2> quadrature = stress_quadrature(at.mesh.order);
    unsigned int        index      = 0;
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        for (unsigned int i = 0; i < at.mesh.n_nodes_per_cell(); ++i)
          {
            const auto initial = initial_state(cells[c], reference_nodes[i]);
            for (unsigned int d = 0; d < 2; ++d)
              at.nodal_fields.at(at.mesh.cells[c][i])[2 + d] =
                initial.displacement[d];
          }
        for (unsigned int q = 0; q < quadrature.size(); ++q, ++index)
          {
            const auto initial = initial_state(cells[c], quadrature.point(q));
            if (index == 0)
              at.point_fields =
                MeshField::zero(4 + initial.law_state.size(),
                                cells.size() * quadrature.size());
            double *values = at.point_fields.at(index);
            std::copy_n(initial.stress.begin(), 4, values);
            std::copy(initial.law_state.begin(),
                      initial.law_state.end(),
                      values + 4);
            at.density.push_back(setting.material.density /
                                 initial.volume_ratio);
          }
      }
    for (unsigned int n = 0; n < n_nodes; ++n)
      for (unsigned int d = 0; d < 2; ++d)
        at.mesh.nodes[n][d] += at.nodal_fields.at(n)[2 + d];
    mark_walls(at.mesh, setting);

    time = Clock();
    walls.clear();
    rezonings    = 0;
    mass_removed = mass_lost = dissipated_before = friction_dissipation = 0.;
    make_body(state, setting.parameters.time_step);
    const auto traction = [&](const unsigned int w, const Point<2> &p) {
      // That of the nearest node of the state at rest.
      double nearest = std::numeric_limits<double>::max(), result = 0.;
      for (const WallForce<2> &force : wall_forces)
        if (force.wall == setting.walls[w].wall && force.area > 0. &&
            force.normal * setting.walls[w].normal > 0.999)
          {
            const double distance =
              p.distance(setting.scene.mesh.vertices[force.vertex]);
            if (distance < nearest)
              {
                nearest = distance;
                result  = force.force * setting.walls[w].tangent / force.area;
              }
          }
      return result;
    };
    body->contact.set_tangential_traction(traction);
    // Where an outlet opens, material starts to fall at once. Where contact
    // finds no acceleration, the first step does without: it is damped.
    const DisplacementVector rest         = body->grid.elements.make_vector();
    const DisplacementVector displacement = body->motion.displacement();
    try
      {
        body->motion.start(displacement, rest);
      }
    catch (const RunError &)
      {
        body->motion.go_on(
          0., setting.parameters.time_step, displacement, rest, rest);
      }
  }



  void
  UpdatedLagrangianFlow::make_body(const MaterialState &state,
                                   const double         first_step)
  {
    body = std::make_unique<MovingBody>(setting, state, time.time, first_step);
    quality_of_new_mesh = find_worst_element(body->mesh(), criterion).quality;
  }



  void
  UpdatedLagrangianFlow::step()
  {
    if (!body)
      {
        time.time_step =
          std::min(setting.parameters.time_step, end_time - time.time);
        time.time += time.time_step;
        ++time.step;
        return;
      }
    bool         is_rezoned = false;
    unsigned int n_failures = 0;
    while (body && !body->motion.try_step(end_time - time.time))
      if (++n_failures >= most_halvings && !is_rezoned)
        {
          is_rezoned = true;
          rezone("a step had no solution");
        }
      else if (body->motion.has_smallest_step())
        throw RunError(describe(time) +
                       "no step has a solution. Try, in section 'Updated "
                       "Lagrangian stage', a smaller 'Time step' or a larger "
                       "'Newmark delta'; or a smaller Scene/Element size.");
    if (!body)
      return;
    end_step();
    keep_elements_good();
  }



  void
  UpdatedLagrangianFlow::end_step()
  {
    time.time_step = body->motion.last_time_step();
    time.time      = body->motion.time();
    ++time.step;
    for (const NodeContact &contact : body->contact.contacts())
      {
        const RigidWall &wall = setting.walls[contact.wall];
        if (!wall.is_axis())
          walls.add(wall.wall,
                    contact.position,
                    time.time_step * (-contact.normal_force * wall.normal +
                                      contact.tangential_force * wall.tangent));
        friction_dissipation += contact.dissipation;
      }
  }



  void
  UpdatedLagrangianFlow::keep_elements_good()
  {
    const TriangleMesh mesh  = body->mesh();
    const WorstElement worst = find_worst_element(mesh, criterion);
    const double       limit = std::min(1., worn_out * quality_of_new_mesh);
    std::string        reason;
    if (worst.quality < limit)
      reason = worst.description();
    else if (surface_leans_on_walls(mesh, worst_surface_angles, setting))
      reason = "the free surface leans on a wall";
    // The body loses what has fallen once it is longer by some elements.
    double lowest = setting.lowest_level;
    for (const Point<2> &node : mesh.nodes)
      lowest = std::min(lowest, node[1]);
    if (reason.empty() &&
        lowest < setting.lowest_level - 3. * setting.element_size)
      reason = "material has fallen below the fall region";
    if (reason.empty())
      return;
    try
      {
        rezone(reason);
      }
    catch (const RunError &error)
      {
        // The old mesh may do for some more steps.
        log << "t = " << time.time << " s: no new mesh (" << reason
            << "): " << error.what() << std::endl;
        if (worst.quality <= 0.)
          throw RunError(describe(time) + error.what());
      }
  }



  void
  UpdatedLagrangianFlow::rezone(const std::string &reason)
  {
    const auto          tractions = body->contact.contacts();
    const MaterialState before    = body->state();
    const double        next      = body->motion.next_time_step();
    const auto          energies  = body->equilibrium->energies();
    RezonedMaterial     rezoned   = rezone_material(setting, before);
    ++rezonings;
    dissipated_before += energies.dissipated;
    mass_removed += rezoned.mass_below;
    mass_lost += rezoned.mass_slivers;
    log << "t = " << time.time << " s: " << reason << ": "
        << rezoned.description << std::endl;
    if (rezoned.state.at.mesh.cells.empty())
      {
        body.reset();
        return;
      }
    make_body(rezoned.state, next);
    const auto traction = [&](const unsigned int w, const Point<2> &p) {
      // Between the two nearest of the old nodes.
      double nearest_below = -1e300, nearest_above = 1e300;
      double below = 0., above = 0.;
      for (const NodeContact &contact : tractions)
        if (contact.wall == w && contact.area > 0.)
          {
            const double distance =
              (contact.position - p) * setting.walls[w].tangent;
            const double value = contact.tangential_force / contact.area;
            if (distance <= 0. && distance > nearest_below)
              {
                nearest_below = distance;
                below         = value;
              }
            if (distance >= 0. && distance < nearest_above)
              {
                nearest_above = distance;
                above         = value;
              }
          }
      if (nearest_below == -1e300)
        return above;
      if (nearest_above == 1e300 || nearest_above == nearest_below)
        return below;
      return below +
             (above - below) * nearest_below / (nearest_below - nearest_above);
    };
    body->contact.set_tangential_traction(traction);
  }
} // namespace Sandglass
