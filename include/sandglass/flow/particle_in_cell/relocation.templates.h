#ifndef sandglass_flow_particle_in_cell_relocation_templates_h
#define sandglass_flow_particle_in_cell_relocation_templates_h

#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/base/prefetch.h>
#include <sandglass/flow/particle_in_cell/relocation.h>

#include <set>
#include <sstream>

namespace Sandglass
{
  /// Which cells touch a vertex where a wall meets the fall region's side.
  template <int dim>
  std::vector<bool>
  find_cells_at_lip(const Scene<dim> &scene)
  {
    std::set<unsigned int> on_wall, on_side;
    for (const auto &face : scene.triangulation.active_face_iterators())
      if (face->at_boundary())
        {
          const auto role = static_cast<BoundaryRole>(face->boundary_id());
          for (const unsigned int v : {0u, 1u})
            {
              if (is_wall(role))
                on_wall.insert(face->vertex_index(v));
              if (role == BoundaryRole::fall_side)
                on_side.insert(face->vertex_index(v));
            }
        }

    std::vector<bool> result(scene.triangulation.n_active_cells(), false);
    for (const auto &cell : scene.triangulation.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (on_wall.count(cell->vertex_index(v)) > 0 &&
            on_side.count(cell->vertex_index(v)) > 0)
          result[cell->active_cell_index()] = true;
    return result;
  }



  template <typename Setting>
  Relocation<Setting>::Relocation(const Scene<dim>              &scene,
                                    const Geometry                &geometry,
                                    const WallParameters          &walls,
                                    const ParticleStageParameters &parameters,
                                    RemovedMass                   &removed)
    : geometry(geometry)
    , removed(removed)
    , communicator(scene.communicator)
    , friction_coefficient(walls.friction_coefficient())
    , stops_at_loss(parameters.on_lost_particle ==
                    ParticleStageParameters::OnLostParticle::stop)
  {
    if (walls.outlet_lip == WallParameters::OutletLip::free)
      is_at_free_lip = find_cells_at_lip(scene);
  }



  template <typename Setting>
  const std::vector<ParticleSlot> &
  Relocation<Setting>::relocate(Strays<Layout> &strays,
                                  Cloud &cloud,
                                  const Clock   &clock)
  {
    wall_impulses.clear();
    auto             &parcels  = strays.parcels;
    const std::size_t n_strays = parcels.size();
    std::size_t       n_found  = 0;
    for (std::size_t n = 0; n < n_strays; ++n)
      {
        // On fine meshes no cache has kept the cells since the pass.
        if (n + 2 * prefetch_distance < n_strays)
          geometry.prefetch(parcels[n + 2 * prefetch_distance].cell);
        if (n + prefetch_distance < n_strays)
          geometry.prefetch_neighbors(parcels[n + prefetch_distance].cell);
        if (find_cell(parcels[n]))
          parcels[n_found++] = parcels[n];
      }
    parcels.resize(n_found);
    throw_if_faulty(clock);
    cloud.insert(parcels, arrivals);
    strays.clear();
    return arrivals;
  }



  template <typename Setting>
  bool
  Relocation<Setting>::find_cell(Parcel &stray)
  {
    using Kind = typename Location::Kind;

    Location location = geometry.find(stray.location, stray.cell);
    if (location.kind == Kind::outside && is_held_by_lip(stray, location))
      location = hold_at_wall(stray, location);

    const bool is_at_boundary =
      location.kind == Kind::outside && !is_open(location.role) &&
      Geometry::is_inside(location.reference_point, -rounding);
    if (location.kind == Kind::inside || is_at_boundary)
      {
        settle(stray, location);
        return true;
      }

    const double mass = stray.properties[Layout::mass];
    if (location.kind == Kind::outside && is_open(location.role))
      removed.discharged += mass;
    else
      {
        if (stops_at_loss || location.kind == Kind::invalid)
          report_fault(stray, location);
        removed.lost += mass;
      }
    return false;
  }



  template <typename Setting>
  void
  Relocation<Setting>::settle(Parcel &stray, const Location &location) const
  {
    const Point<dim> reference_point =
      Geometry::Shape::clamp(location.reference_point, margin);
    // The position follows: on the axis a particle would have no radius.
    if (reference_point != location.reference_point)
      stray.location = geometry.shape(location.cell).to_real(reference_point);
    stray.reference_point = reference_point;
    stray.cell            = location.cell;
  }



  template <typename Setting>
  bool
  Relocation<Setting>::is_held_by_lip(const Parcel   &stray,
                                        const Location &location) const
  {
    return !is_at_free_lip.empty() && is_wall(location.role) &&
           (is_at_free_lip[stray.cell] || is_at_free_lip[location.cell]);
  }



  template <typename Setting>
  typename Relocation<Setting>::Location
  Relocation<Setting>::hold_at_wall(Parcel &stray, const Location &location)
  {
    const auto          &shape   = geometry.shape(location.cell);
    const auto          &ends    = Geometry::Shape::face_nodes[location.face];
    const Point<dim>     start   = shape.node(ends[0]);
    const Tensor<1, dim> edge    = shape.node(ends[1]) - start;
    const Tensor<1, dim> tangent = edge / edge.norm();
    Tensor<1, dim>       normal({tangent[1], -tangent[0]});

    const Tensor<1, dim> offset = stray.location - start;
    if (normal * offset < 0.)
      normal *= -1.;

    double *const stored_velocity = &stray.properties[Layout::velocity];
    const Tensor<1, dim> velocity({stored_velocity[0], stored_velocity[1]});
    const double         into_wall  = std::max(0., velocity * normal);
    const double         along_wall = velocity * tangent;
    const double         friction =
      std::min(std::abs(along_wall), friction_coefficient * into_wall);
    const Tensor<1, dim> held_velocity =
      velocity - into_wall * normal -
      std::copysign(friction, along_wall) * tangent;
    for (unsigned int d = 0; d < dim; ++d)
      stored_velocity[d] = held_velocity[d];

    // A little inside, so that the walk ends in a cell.
    stray.location -= (normal * offset + margin * edge.norm()) * normal;
    wall_impulses.push_back(
      {{{start, shape.node(ends[1])}},
       std::clamp(offset * edge / edge.norm_square(), 0., 1.),
       normal,
       stray.properties[Layout::mass] * (held_velocity - velocity),
       held_velocity});
    return geometry.find(stray.location, location.cell);
  }



  template <typename Setting>
  void
  Relocation<Setting>::report_fault(const Parcel   &stray,
                                      const Location &location)
  {
    if (!fault.empty())
      return;
    std::ostringstream message;
    message << "Particle " << stray.id << " at (" << stray.location
            << ") m with velocity (" << stray.properties[Layout::velocity]
            << ' ' << stray.properties[Layout::velocity + 1]
            << ") m/s, last in cell " << stray.cell << ", ";
    if (location.kind == Location::Kind::invalid)
      message
        << "has a position that is not a number; the run is unstable. Try "
           "a smaller Particle stage/Time step (auto follows the critical "
           "one) or another Density update.";
    else
      message << "has left the grid through the " << name_of(location.role)
              << ". Try a smaller Particle stage/Time step, or set On lost "
                 "particle = remove to go on without such particles.";
    fault = message.str();
  }



  template <typename Setting>
  void
  Relocation<Setting>::throw_if_faulty(const Clock &clock) const
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    if (n_ranks == 1)
      {
        if (!fault.empty())
          throw RunError(describe(clock) + fault);
        return;
      }
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int faulty_rank =
      Utilities::MPI::min(fault.empty() ? n_ranks : rank, communicator);
    if (faulty_rank < n_ranks)
      throw RunError(describe(clock) + Utilities::MPI::broadcast(communicator,
                                                                 fault,
                                                                 faulty_rank));
  }
} // namespace Sandglass

#endif
