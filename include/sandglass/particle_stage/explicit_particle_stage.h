#ifndef sandglass_particle_stage_explicit_particle_stage_h
#define sandglass_particle_stage_explicit_particle_stage_h

#include <sandglass/particle_stage/critical_time_step.h>
#include <sandglass/particle_stage/nodal_equations.h>
#include <sandglass/particle_stage/particle_pass.h>
#include <sandglass/particle_stage/particle_splitting.h>
#include <sandglass/particle_stage/particle_stage.h>

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
      , nodal_sums(geometry,
                   CellStiffness<Setting>::stiff_share * material.density,
                   parameters.force_integration == ForceIntegration::cell ?
                     initial_configuration.points :
                     std::vector<Point<dim>>())
      , mass_matrix(*scene.nodes, geometry, parameters.consistent_mass_share)
      , volumetric_average(
          *scene.nodes,
          geometry,
          density_update == DensityUpdate::separation ? material.density : 0.,
          parameters.volumetric_strain == VolumetricStrain::averaged)
      , critical(material.elasticity(), geometry, scene)
      , relocation(scene, geometry, walls, parameters)
      , splitting(geometry,
                  initial_configuration,
                  scene.mesh,
                  material.density,
                  volumetric_average.smallest_density,
                  parameters.split_particles)
    {
      seed_particles();
      if (parameters.has_automatic_time_step)
        {
          seeded_critical_time_step = critical_time_step();
          last_local_eigenvalue     = local_eigenvalue();
          seeded_local_eigenvalue   = last_local_eigenvalue;
        }
    }

    void
    step() override
    {
      // Steps 2 to 4: sums over the particles, mostly left by the last pass
      begin(StepPart::mass_matrix);
      update_sums();
      begin(StepPart::time_step);
      clock.time_step = choose_time_step();
      // Step 2: nodal velocity
      begin(StepPart::nodal_equations);
      solve_velocity(fields, *scene.nodes, mass_matrix);
      // Steps 4 and 5: contact and nodal acceleration
      solve_acceleration(fields,
                         *scene.nodes,
                         mass_matrix,
                         contact,
                         scene.gravity,
                         clock.time_step);
      // Step 7: the velocity that deforms and moves the particles
      begin(StepPart::velocity_map);
      nodal_sums.map_momentum(cloud.blocks(),
                              fields.acceleration,
                              clock.time_step,
                              fields.mapped_velocity);
      solve_mapped_velocity(fields, mass_matrix, contact, clock.time_step);
      begin(StepPart::volumetric_strain);
      volumetric_average.compute(cloud.blocks(),
                                 nodal_sums,
                                 fields.mapped_velocity);
      // Steps 6, 8 and 9: velocity, stress, density and position
      begin(StepPart::particles);
      particle_steps += cloud.n_locally_owned_particles();
      plastic_dissipation +=
        volumetric_average.is_on ? pass<true>() : pass<false>();
      begin(StepPart::relocation);
      const auto &arrivals = relocation.relocate(strays, cloud, clock);
      for_each_sums([&](auto &cells) { cells.add(cloud.blocks(), arrivals); });
      contact.add_impulses(relocation.wall_impulses);
      begin(StepPart::splitting);
      if (splitting.is_on() && clock.step % splitting.interval == 0)
        split_particles();
      begin(StepPart::sums_at_nodes);
      scatter_sums();
      // Step 10
      clock.time += clock.time_step;
      ++clock.step;
      begin(StepPart::order);
      check_speed();
      cloud.change_blocks().sort_if_mixed();
      begin(StepPart::done);
    }

    double
    critical_time_step() override
    {
      update_sums();
      if (!parameters.has_automatic_time_step) // without stiffness so far
        nodal_sums.template scatter<true>(cloud.blocks(), fields.sums);
      return find_critical_time_step();
    }

    void
    set_initial_state(const InitialStateFunction &initial_state) override
    {
      cloud.edit([&](ParticleCloud::Handler &handler) {
        for (auto &particle : handler)
          set_initial_state(initial_state, particle);
      });
      take_out_strays();
      relocation.relocate(strays, cloud, clock);
      cloud.start_new_edition();
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
    /// Steps 6, 8 and 9, and the next step's sums; returns the plastic work.
    template <bool is_averaged>
    double
    pass()
    {
      return ParticlePass<Setting, density_update, is_averaged>(
               geometry,
               stress_update,
               parameters.stress_integration,
               clock.time_step)
        .run(cloud.change_blocks(),
             fields.acceleration,
             fields.mapped_velocity,
             nodal_sums,
             volumetric_average,
             strays);
    }

    /// Call `function(sums)` for the sums over particles in their cells.
    template <typename Function>
    void
    for_each_sums(const Function &function)
    {
      function(nodal_sums.cells);
      if (volumetric_average.is_on)
        function(*volumetric_average.cells);
    }

    void
    split_particles()
    {
      splitting.split(cloud.change_blocks(),
                      fields.mapped_velocity,
                      [this](const unsigned int cell) {
                        for_each_sums([&](auto &cells) {
                          cells.compute(cloud.blocks(), cell);
                        });
                      });
    }

    /// The sums at the nodes, anew if particles have changed by other means.
    void
    update_sums()
    {
      if (edition_of_sums != cloud.edition())
        {
          for_each_sums([&](auto &cells) { cells.compute(cloud.blocks()); });
          scatter_sums();
          edition_of_sums = cloud.edition();
        }
      mass_matrix.assemble(cloud.blocks(), nodal_sums, fields.sums);
    }

    void
    scatter_sums()
    {
      if (parameters.has_automatic_time_step)
        nodal_sums.template scatter<true>(cloud.blocks(), fields.sums);
      else
        nodal_sums.template scatter<false>(cloud.blocks(), fields.sums);
    }

    void
    set_initial_state(const InitialStateFunction       &initial_state,
                      Particles::ParticleAccessor<dim> &particle) const
    {
      const auto         cell = particle.get_surrounding_cell();
      const InitialState initial =
        initial_state(cell->active_cell_index(),
                      particle.get_reference_location());
      const auto state = particle.get_properties();
      std::copy_n(initial.stress.data(),
                  initial.stress.size(),
                  state.begin() + Property::stress);
      state[Property::density] = unstressed_density / initial.volume_ratio;
      particle.set_location(particle.get_location() + initial.displacement);
      particle.set_reference_location(geometry.shape(cell->active_cell_index())
                                        .to_reference(particle.get_location()));
    }

    /// All particles that are outside their cells.
    void
    take_out_strays()
    {
      std::vector<ParticleSlot> slots;
      cloud.blocks().for_each([&](const ParticleSlot &slot) {
        const Point<dim> reference =
          cloud.blocks()[slot.block].point(ParticleBlock::reference, slot.lane);
        if (!CellGeometry<Setting::cell_type>::is_inside(
              reference, Relocation<Setting::cell_type>::margin))
          slots.push_back(slot);
      });
      strays.clear();
      // The order that ParticleBlocks::remove() asks for.
      for (auto slot = slots.rbegin(); slot != slots.rend(); ++slot)
        strays.add(*slot);
      strays.take_out(cloud.change_blocks());
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
              Parcel parcel{};
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
    }

    double
    find_critical_time_step() override
    {
      // Within a few per cent of the eigenvalue; the safety factor covers them.
      constexpr unsigned int n_iterations = 7;
      return critical.compute(cloud.blocks(),
                              nodal_sums,
                              mass_matrix,
                              contact,
                              fields.sums,
                              n_iterations);
    }

    double
    local_eigenvalue() const override
    {
      return critical.local_eigenvalue(fields.sums);
    }

    const CellGeometry<Setting::cell_type>         geometry;
    const InitialConfiguration<Setting::cell_type> initial_configuration;
    const double                                   unstressed_density;
    const StressUpdate<density_update>             stress_update;
    NodalSums<Setting>                             nodal_sums;
    MassMatrix<Setting>                            mass_matrix;
    VolumetricAverage<Setting>                     volumetric_average;
    CriticalTimeStep<Setting>                      critical;
    Relocation<Setting::cell_type>                 relocation;
    ParticleSplitting<Setting>                     splitting;

    /// Of the particles that `nodal_sums` hold; none yet.
    unsigned int edition_of_sums = numbers::invalid_unsigned_int;

    /// Kept between steps to avoid allocation.
    Strays strays;
  };
} // namespace Sandglass

#endif
