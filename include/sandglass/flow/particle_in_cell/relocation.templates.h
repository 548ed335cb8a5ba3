#ifndef sandglass_flow_particle_in_cell_relocation_templates_h
#define sandglass_flow_particle_in_cell_relocation_templates_h

#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/base/prefetch.h>
#include <sandglass/flow/particle_in_cell/relocation.h>
#include <sandglass/walls/coulomb.h>
#include <sandglass/walls/face_geometry.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace Sandglass
{
  /// Which cells touch a vertex where a wall ends at the open part of the
  /// boundary.
  template <int dim>
  std::vector<bool>
  find_cells_at_lip(const Scene<dim> &scene)
  {
    std::set<unsigned int> on_wall, on_opening;
    for (const auto &face : scene.triangulation.active_face_iterators())
      if (face->at_boundary())
        {
          const BoundaryPart part =
            boundary_part(scene.walls, face->boundary_id());
          for (const unsigned int v : face->vertex_indices())
            {
              if (part.wall != no_wall)
                on_wall.insert(face->vertex_index(v));
              if (is_open(part.role))
                on_opening.insert(face->vertex_index(v));
            }
        }

    std::vector<bool> result(scene.triangulation.n_active_cells(), false);
    for (const auto &cell : scene.triangulation.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (on_wall.count(cell->vertex_index(v)) > 0 &&
            on_opening.count(cell->vertex_index(v)) > 0)
          result[cell->active_cell_index()] = true;
    return result;
  }



  template <typename Setting>
  Relocation<Setting>::Relocation(const Scene<dim>     &scene,
                                  const Geometry       &geometry,
                                  const WallParameters &wall_parameters,
                                  const ParticleStageParameters &parameters,
                                  RemovedMass                   &removed)
    : geometry(geometry)
    , walls(scene.walls)
    , removed(removed)
    , communicator(scene.communicator)
    , stops_at_loss(parameters.on_lost_particle !=
                    ParticleStageParameters::OnLostParticle::remove)
    , holds_at_top(parameters.on_lost_particle ==
                   ParticleStageParameters::OnLostParticle::hold)
  {
    if (wall_parameters.outlet_lip == WallParameters::OutletLip::free)
      is_at_free_lip = find_cells_at_lip(scene);
  }



  template <typename Setting>
  const std::vector<ParticleSlot> &
  Relocation<Setting>::relocate(Strays<Layout> &strays,
                                Cloud          &cloud,
                                const Clock    &clock)
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
    else if (location.kind == Kind::outside && holds_at_top &&
             location.part.role == BoundaryRole::top)
      location = hold_at_top(stray, location);

    // In space a wall may be curved or twisted: nodes that slide along it, and
    // a lip's neighbouring faces, take particles a little beyond its faces; in
    // an oblique cell that is a larger share of it. In a hopper from square to
    // round it is 0.1 with 16 cells across the outlet, 0.22 with six.
    constexpr double largest_depth = 0.3;
    const double     depth =
      dim == 3 && location.part.wall != no_wall ? largest_depth : rounding;
    const bool is_at_boundary =
      location.kind == Kind::outside && !is_open(location.part.role) &&
      Geometry::is_inside(location.reference_point, -depth);
    if (location.kind == Kind::inside || is_at_boundary)
      {
        settle(stray, location);
        return true;
      }

    const double mass = stray.properties[Layout::mass];
    if (location.kind == Kind::outside && is_open(location.part.role))
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
    return !is_at_free_lip.empty() && location.part.wall != no_wall &&
           (is_at_free_lip[stray.cell] || is_at_free_lip[location.cell]);
  }



  template <typename Setting>
  typename Relocation<Setting>::Exit
  Relocation<Setting>::find_exit(const Parcel   &stray,
                                 const Location &location) const
  {
    const auto &shape = geometry.shape(location.cell);
    const auto &nodes = Geometry::Shape::face_nodes[location.face];

    std::array<Point<dim>, dim> points;
    for (unsigned int i = 0; i < dim; ++i)
      points[i] = shape.node(nodes[i]);
    Exit exit;
    exit.normal       = unit_normal<dim>(points);
    exit.distance     = exit.normal * (stray.location - points[0]);
    exit.small_length = margin * points[0].distance(points[1]);
    if (exit.distance < 0.)
      {
        exit.normal *= -1.;
        exit.distance *= -1.;
      }
    return exit;
  }



  template <typename Setting>
  typename Relocation<Setting>::Location
  Relocation<Setting>::put_back(Parcel         &stray,
                                const Exit     &exit,
                                const Location &location) const
  {
    stray.location -= (exit.distance + exit.small_length) * exit.normal;
    return geometry.find(stray.location, location.cell);
  }



  template <typename Setting>
  typename Relocation<Setting>::Location
  Relocation<Setting>::hold_at_wall(Parcel &stray, const Location &location)
  {
    const Wall<dim>      &wall   = walls[location.part.wall];
    const Exit            exit   = find_exit(stray, location);
    const Tensor<1, dim> &normal = exit.normal;

    // Coulomb's law for the changes of velocity, in place of impulses.
    Tensor<1, dim> velocity;
    for (unsigned int d = 0; d < dim; ++d)
      velocity[d] = stray.properties[Layout::velocity + d];
    const double         into_wall = std::max(0., velocity * normal);
    const Tensor<1, dim> slip =
      velocity - (velocity * normal) * normal - wall.velocity;
    const Tensor<1, dim> change =
      coulomb(-slip, wall.friction_coefficient * into_wall).force -
      into_wall * normal;
    for (unsigned int d = 0; d < dim; ++d)
      stray.properties[Layout::velocity + d] += change[d];

    const Location   held = put_back(stray, exit, location);
    WallImpulse<dim> impulse{location.cell,
                             location.face,
                             {},
                             stray.properties[Layout::mass] * change,
                             velocity + change - wall.velocity,
                             wall.velocity};
    const auto       shape_values =
      Geometry::Shape::shape_values(Geometry::Shape::clamp(
        geometry.shape(location.cell).to_reference(stray.location), 0.));
    std::copy(shape_values.begin(),
              shape_values.end(),
              impulse.shape_values.begin());
    wall_impulses.push_back(impulse);
    return held;
  }



  template <typename Setting>
  typename Relocation<Setting>::Location
  Relocation<Setting>::hold_at_top(Parcel         &stray,
                                   const Location &location) const
  {
    const Exit     exit = find_exit(stray, location);
    Tensor<1, dim> velocity;
    for (unsigned int d = 0; d < dim; ++d)
      velocity[d] = stray.properties[Layout::velocity + d];
    const double outwards = std::max(0., velocity * exit.normal);
    for (unsigned int d = 0; d < dim; ++d)
      stray.properties[Layout::velocity + d] -= outwards * exit.normal[d];
    return put_back(stray, exit, location);
  }



  template <typename Setting>
  void
  Relocation<Setting>::report_fault(const Parcel   &stray,
                                    const Location &location)
  {
    if (!fault.empty())
      return;
    Point<dim> velocity;
    for (unsigned int d = 0; d < dim; ++d)
      velocity[d] = stray.properties[Layout::velocity + d];
    std::ostringstream message;
    message << "Particle " << stray.id << " at (" << stray.location
            << ") m with velocity (" << velocity << ") m/s, last in cell "
            << stray.cell << ", ";
    if (location.kind == Location::Kind::invalid)
      message
        << "has a position that is not a number; the run is unstable. Try "
           "a smaller Particle stage/Time step (auto follows the critical "
           "one) or another Density update.";
    else
      message << "has left the grid through the "
              << (location.part.wall == no_wall ?
                    std::string(name_of(location.part.role)) :
                    walls[location.part.wall].name)
              << ". Try a smaller Particle stage/Time step"
              << (location.part.role == BoundaryRole::top ?
                    " or more Scene/Headroom, or set On lost particle = hold "
                    "to keep such particles, or" :
                    ", or set On lost particle =")
              << " remove to go on without them.";
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
