#ifndef sandglass_particle_stage_explicit_particle_stage_h
#define sandglass_particle_stage_explicit_particle_stage_h

#include <sandglass/particle_stage/nodal_equations.h>
#include <sandglass/particle_stage/nodal_sums.h>
#include <sandglass/particle_stage/particle_stage.h>
#include <sandglass/particle_stage/particle_velocity.h>

namespace Sandglass
{
  /// The particle stage with its compile-time choices made.
  template <typename Setting, DensityUpdate density_update>
  class ExplicitParticleStage : public ParticleStage
  {
  public:
    ExplicitParticleStage(const Scene                   &scene,
                          const MaterialParameters      &material,
                          const WallParameters          &walls,
                          const ParticleStageParameters &parameters)
      : ParticleStage(scene, walls, parameters)
      , geometry(scene)
      , initial_configuration(scene, geometry)
      , unstressed_density(material.density)
      , stress_update(material.drucker_prager(), material.density)
      , mass_matrix(*scene.nodes, geometry, parameters.consistent_mass_share)
      , volumetric_average(
          *scene.nodes,
          scene.triangulation.n_active_cells(),
          density_update == DensityUpdate::separation ? material.density : 0.,
          parameters.volumetric_strain == VolumetricStrain::averaged)
      , critical(material.elasticity(), material.density, scene)
      , relocation(scene, geometry, walls, parameters)
    {
      seed_particles();
      if (parameters.has_automatic_time_step)
        seeded_critical_time_step = critical_time_step();
    }

    void
    step() override
    {
      timer.start();
      // Steps 2 to 4: sums over the particles
      NodalSums<Setting>::compute(cloud, geometry, fields.sums);
      mass_matrix.assemble(cloud, fields.sums);
      clock.time_step = choose_time_step();
      // Step 2: nodal velocity
      solve_velocity(fields, *scene.nodes, mass_matrix);
      // Steps 4 and 5: contact and nodal acceleration
      solve_acceleration(fields,
                         *scene.nodes,
                         mass_matrix,
                         contact,
                         scene.gravity,
                         clock.time_step);
      // Step 6, and the sums of step 7
      update_particle_velocity<Setting>(cloud,
                                        geometry,
                                        fields.acceleration,
                                        clock.time_step,
                                        fields.mapped_velocity);
      // Step 7: the velocity that deforms and moves the particles
      solve_mapped_velocity(fields, mass_matrix, contact);
      // Steps 8 and 9: stress, density and position
      volumetric_average.compute(cloud, geometry, fields.mapped_velocity);
      strays.clear();
      plastic_dissipation +=
        volumetric_average.is_on ? move<true>() : move<false>();
      particle_steps += cloud.handler.n_locally_owned_particles();
      relocation.relocate(strays, cloud, clock);
      contact.add_impulses(relocation.wall_impulses);
      // Step 10
      clock.time += clock.time_step;
      ++clock.step;
      check_speed();
      timer.stop();
    }

    double
    critical_time_step() override
    {
      NodalSums<Setting>::compute(cloud, geometry, fields.sums);
      mass_matrix.assemble(cloud, fields.sums);
      return find_critical_time_step();
    }

    void
    set_initial_state(const InitialStateFunction &initial_state) override
    {
      strays.clear();
      for (const auto &cell : cloud.owned_cells())
        {
          const auto particles = cloud.handler.particles_in_cell(cell);
          for (auto particle = particles.begin(); particle != particles.end();
               ++particle)
            {
              const InitialState initial =
                initial_state(cell->active_cell_index(),
                              particle->get_reference_location());
              const auto state = particle->get_properties();
              std::copy_n(initial.stress.data(),
                          initial.stress.size(),
                          state.begin() + Property::stress);
              state[Property::density] =
                unstressed_density / initial.volume_ratio;
              particle->set_location(particle->get_location() +
                                     initial.displacement);
              particle->set_reference_location(
                geometry.shape(cell->active_cell_index())
                  .to_reference(particle->get_location()));
              strays.push_back({particle, cell->active_cell_index()});
            }
        }
      relocation.relocate(strays, cloud, clock);
    }

    Point<dim>
    initial_position(const types::particle_index id) const override
    {
      return initial_configuration.position(id);
    }

    RemovedMass &
    removed_mass() override
    {
      return relocation.removed;
    }

  private:
    /// Steps 8 and 9; returns the plastic work in J.
    template <bool is_averaged>
    double
    move()
    {
      return ParticleMotion<Setting, density_update, is_averaged>(
               stress_update,
               volumetric_average,
               parameters.stress_integration,
               clock.time_step)
        .compute(cloud, geometry, fields.mapped_velocity, strays);
    }

    void
    seed_particles()
    {
      const auto        &points = initial_configuration.points;
      const unsigned int n      = points.size();
      for (const auto &cell : cloud.owned_cells())
        {
          const unsigned int index = cell->active_cell_index();
          if (!scene.mesh.cells[index].is_filled)
            continue;
          for (unsigned int k = 0; k < n; ++k)
            {
              ParticleCloud::Parcel parcel{};
              parcel.cell            = index;
              parcel.id              = n * index + k;
              parcel.reference_point = points[k];
              parcel.location = initial_configuration.position(parcel.id);
              parcel.properties[Property::mass] =
                unstressed_density * initial_configuration.volume(parcel.id);
              parcel.properties[Property::density] = unstressed_density;
              cloud.insert(parcel);
            }
        }
      cloud.handler.update_cached_numbers();
    }

    double
    find_critical_time_step() override
    {
      // Within a few per cent of the eigenvalue; the safety factor covers them.
      constexpr unsigned int n_iterations = 10;
      return critical.compute(
        cloud, geometry, mass_matrix, contact, fields.sums, n_iterations);
    }

    const CellGeometry<Setting::cell_type>         geometry;
    const InitialConfiguration<Setting::cell_type> initial_configuration;
    const double                                   unstressed_density;
    const StressUpdate<density_update>             stress_update;
    MassMatrix<Setting>                            mass_matrix;
    VolumetricAverage<Setting>                     volumetric_average;
    CriticalTimeStep<Setting>                      critical;
    Relocation<Setting::cell_type>                 relocation;

    /// Kept between steps to avoid allocation.
    std::vector<Stray> strays;
  };
} // namespace Sandglass

#endif
