#ifndef sandglass_tests_benchmark_plain_loop_h
#define sandglass_tests_benchmark_plain_loop_h

#include <deal.II/particles/particle_handler.h>

#include <sandglass/continuum/in_plane_increment.h>
#include <sandglass/flow/particle_in_cell/nodal_equations.h>
#include <sandglass/flow/particle_in_cell/particle_motion.h>
#include <sandglass/flow/particle_in_cell/relocation.h>
#include <sandglass/flow/particle_in_cell/stress_update.h>
#include <sandglass/material/drucker_prager.h>

#include <stdexcept>
#include <vector>

#include "plain_particle.h"

/**
 * The step of Section 4.4 as one writes it first, to measure the particle stage
 * against: three passes over the particles where deal.II's ParticleHandler
 * stores them, one particle at a time. With the lumped mass matrix, a density
 * that follows separation, and the lip on the floor; on one rank.
 */
template <typename Setting>
class PlainLoop
{
public:
  static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
  static constexpr int          dim     = Setting::dim;

  using Handler    = dealii::Particles::ParticleHandler<dim>;
  using Iterator   = dealii::Particles::ParticleIterator<dim>;
  using Layout     = typename Setting::Layout;
  using Law        = Sandglass::DruckerPrager;
  using Geometry   = Sandglass::CellGeometry<Setting::cell_type>;
  using Shape      = typename Setting::Shape;
  using Relocation = Sandglass::Relocation<Setting>;
  using NodalSum   = Sandglass::NodalSum<dim>;
  using Parcel     = Sandglass::Parcel<Layout>;

  /// @param particles  copied with all their properties.
  PlainLoop(const Sandglass::Scene<dim>         &scene,
            const Sandglass::MaterialParameters &material,
            const Sandglass::WallParameters     &walls,
            const Handler                       &particles)
    : fields(*scene.nodes)
    , contact(scene, walls)
    , handler(scene.triangulation, scene.mapping, Layout::n_properties)
    , scene(scene)
    , geometry(scene)
    , mass_matrix(*scene.nodes, geometry, 0.)
    , stress_update(Law(material),
                    material.density,
                    Sandglass::ParticleStageParameters())
  {
    for (const auto &cell : scene.triangulation.active_cell_iterators())
      {
        cells.push_back(cell);
        for (const auto &particle : particles.particles_in_cell(cell))
          handler.insert_particle(particle.get_location(),
                                  particle.get_reference_location(),
                                  particle.get_id(),
                                  cell,
                                  particle.get_properties());
      }
  }

  void
  step(const double time_step)
  {
    sum_at_nodes();
    solve_acceleration(fields,
                       *scene.nodes,
                       mass_matrix,
                       contact,
                       scene.gravity,
                       time_step,
                       [](const Sandglass::NodalField<dim> &) {});
    accelerate_particles(time_step);
    solve_mapped_velocity(fields, mass_matrix, contact, time_step);
    deform_and_move_particles(time_step);
    relocate();
  }

  /// Steps 2 to 4: mass, momentum and internal force of the nodes.
  void
  sum_at_nodes()
  {
    fields.sums.start_sum();
    for_each_cell([&](const unsigned int cell, const auto &particles) {
      const Shape &shape = geometry.shape(cell);
      Sandglass::CellValues<NodalSum::n_components, n_nodes> sums{};
      for (auto &particle : particles)
        PlainParticle::add_to_sums<Setting>(
          PlainParticle::state_of<Layout>(particle), shape, sums);
      Sandglass::scatter(sums, geometry.nodes(cell), fields.sums);
    });
    fields.sums.finish_sum();
  }

  Sandglass::NodalFields<dim> fields;
  Sandglass::Contact<dim>     contact;
  Handler                     handler;

private:
  using State    = Sandglass::ParticleState<Layout, double>;
  using Location = typename Geometry::Location;

  struct Stray
  {
    Iterator     particle;
    unsigned int cell;
  };

  /// Call `function(cell index, particles)` for each cell with particles.
  template <typename Function>
  void
  for_each_cell(const Function &function) const
  {
    for (unsigned int index = 0; index < cells.size(); ++index)
      {
        const auto particles = handler.particles_in_cell(cells[index]);
        if (particles.begin() != particles.end())
          function(index, particles);
      }
  }

  /// Step 6, and the momentum of step 7.
  void
  accelerate_particles(const double time_step)
  {
    fields.mapped_velocity.start_sum();
    for_each_cell([&](const unsigned int cell, const auto &particles) {
      const auto &nodes         = geometry.nodes(cell);
      const auto  accelerations = Sandglass::gather(fields.acceleration, nodes);
      Sandglass::CellValues<dim, n_nodes> momenta{};
      for (auto &particle : particles)
        {
          const auto properties = particle.get_properties();
          const auto values     = Shape::shape_values(
            Sandglass::components_of<dim>(particle.get_reference_location()));
          const auto acceleration =
            Sandglass::interpolate(accelerations, values);
          for (unsigned int d = 0; d < dim; ++d)
            {
              double &velocity = properties[Layout::velocity + d];
              velocity += time_step * acceleration[d];
              for (unsigned int i = 0; i < n_nodes; ++i)
                momenta[i][d] +=
                  values[i] * properties[Layout::mass] * velocity;
            }
        }
      Sandglass::scatter(momenta, nodes, fields.mapped_velocity);
    });
    fields.mapped_velocity.finish_sum();
  }

  /// Steps 8 and 9: stress, density and position.
  void
  deform_and_move_particles(const double time_step)
  {
    strays.clear();
    for_each_cell([&](const unsigned int cell, const auto &particles) {
      const auto velocities =
        Sandglass::gather(fields.mapped_velocity, geometry.nodes(cell));
      for (auto particle = particles.begin(); particle != particles.end();
           ++particle)
        if (!stays_inside(
              *particle, geometry.shape(cell), velocities, time_step))
          strays.push_back({particle, cell});
    });
  }

  /// Whether the particle is still in its cell.
  template <typename Particle, typename Velocities>
  bool
  stays_inside(Particle         &particle,
               const Shape      &shape,
               const Velocities &velocities,
               const double      time_step) const
  {
    State      state = PlainParticle::state_of<Layout>(particle);
    const auto velocity =
      Sandglass::interpolate(velocities, Shape::shape_values(state.reference));
    auto gradient =
      Sandglass::gradient_of(velocities,
                             shape.shape_gradients(state.reference));
    for (auto &row : gradient)
      for (double &entry : row)
        entry *= time_step;
    const double hoop = Setting::has_hoop_strain ?
                          time_step * velocity[0] / state.location[0] :
                          0.;
    using Increment = typename Setting::Kinematics::template Increment<double>;
    const Increment increment(gradient, hoop);
    const auto prediction = stress_update.law.predict(increment, time_step);
    stress_update(
      state,
      Sandglass::ParticleDeformation<std::decay_t<decltype(prediction)>,
                                     std::decay_t<decltype(increment.rotation)>,
                                     double>{prediction,
                                             increment.rotation,
                                             1. / increment.jacobian});
    Sandglass::move(velocity, time_step, shape, state);

    PlainParticle::store_moved_state(state, particle);
    return Geometry::is_inside(state.reference, Relocation::margin);
  }

  /// The end of step 9: strays go to their new cells or leave the grid.
  void
  relocate()
  {
    parcels.clear();
    for (const Stray &stray : strays)
      {
        const auto    &particle = *stray.particle;
        const Location location =
          geometry.find(particle.get_location(), stray.cell);
        if (location.kind == Location::Kind::outside &&
            is_open(location.part.role))
          continue;
        if (!Geometry::is_inside(location.reference_point,
                                 -Relocation::rounding))
          throw std::runtime_error("a particle has left the grid");
        add_parcel(particle, location);
      }
    // Backwards, the iterators of the same cell that are still to come stay
    // valid.
    for (auto stray = strays.rbegin(); stray != strays.rend(); ++stray)
      handler.remove_particle(stray->particle);
    for (const Parcel &parcel : parcels)
      handler.insert_particle(
        parcel.location,
        parcel.reference_point,
        parcel.id,
        cells[parcel.cell],
        dealii::ArrayView<const double>(parcel.properties.data(),
                                        parcel.properties.size()));
  }

  template <typename Particle>
  void
  add_parcel(const Particle &particle, const Location &location)
  {
    Parcel parcel{location.cell,
                  particle.get_id(),
                  particle.get_location(),
                  Shape::clamp(location.reference_point, Relocation::margin),
                  {}};
    if (parcel.reference_point != location.reference_point)
      parcel.location =
        geometry.shape(location.cell).to_real(parcel.reference_point);
    const auto properties = particle.get_properties();
    std::copy(properties.begin(), properties.end(), parcel.properties.begin());
    parcels.push_back(parcel);
  }

  const Sandglass::Scene<dim>       &scene;
  const Geometry                     geometry;
  Sandglass::MassMatrix<Setting>     mass_matrix;
  const Sandglass::StressUpdate<Law> stress_update;
  std::vector<typename dealii::Triangulation<dim>::active_cell_iterator> cells;
  std::vector<Stray>                                                     strays;
  std::vector<Parcel> parcels;
};

#endif
