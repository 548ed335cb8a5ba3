#ifndef sandglass_flow_particle_in_cell_explicit_particle_stage_h
#define sandglass_flow_particle_in_cell_explicit_particle_stage_h

#include <sandglass/flow/particle_in_cell/box_friction.h>
#include <sandglass/flow/particle_in_cell/cell_sums_checkpoint.h>
#include <sandglass/flow/particle_in_cell/critical_time_step.h>
#include <sandglass/flow/particle_in_cell/feed.h>
#include <sandglass/flow/particle_in_cell/law_interface.h>
#include <sandglass/flow/particle_in_cell/nodal_equations.h>
#include <sandglass/flow/particle_in_cell/outlet_masses.h>
#include <sandglass/flow/particle_in_cell/particle_splitting.h>
#include <sandglass/flow/particle_in_cell/particle_stage.h>
#include <sandglass/flow/particle_in_cell/relocation.h>
#include <sandglass/flow/particle_in_cell/seed_particles.h>
#include <sandglass/flow/particle_in_cell/stage_totals.h>
#include <sandglass/flow/throw_law_failure.h>
#include <sandglass/scene/mesh_faces.h>

#include <algorithm>
#include <functional>
#include <memory>

namespace Sandglass
{
  /// The particle stage with its compile-time choices made.
  template <typename Setting>
  class ExplicitParticleStage final
    : public ParticleStage<typename Setting::Layout>
  {
  public:
    static constexpr int dim = Setting::dim;

    using Law = LawInterface<Setting>;
    /// Makes the law for the cells of this geometry.
    using MakeLaw    = std::function<std::unique_ptr<const Law>(
      const CellGeometry<Setting::cell_type> &geometry)>;
    using Layout     = typename Setting::Layout;
    using Kinematics = typename Setting::Kinematics;
    using Stage      = ParticleStage<Layout>;
    using Scene      = typename Stage::Scene;
    using Parcel     = typename Stage::Parcel;

    /// @param density  of the unstressed material, in kg/m^3.
    ExplicitParticleStage(const Scene                   &scene,
                          const MakeLaw                 &make_law,
                          const double                   density,
                          const WallParameters          &walls,
                          const ParticleStageParameters &parameters,
                          const FeedParameters          &feed_parameters)
      : Stage(scene, walls, parameters)
      , geometry(scene)
      , initial_configuration(scene,
                              geometry,
                              feed_parameters.kind != FeedKind::none)
      , has_unequal_cells(cells_differ_much(scene.mesh, initial_configuration))
      , pic_share(parameters.pic_share.value_or(
          is_in_unequal_hexahedra() ? automatic_pic_share : 0.))
      , unstressed_density(density)
      , law(make_law(geometry))
      , nodal_sums(geometry,
                   law->loosest_density(),
                   parameters.force_integration == ForceIntegration::cell ?
                     initial_configuration.points :
                     std::vector<Point<dim>>())
      , volumetric_average(*scene.nodes,
                           geometry,
                           law->loosest_density(),
                           parameters.volumetric_strain ==
                               VolumetricStrain::averaged &&
                             law->takes_averaged_strain)
      , relocation(scene, geometry, walls, parameters, removed)
      , splitting(geometry,
                  initial_configuration,
                  density,
                  law->loosest_density(),
                  parameters.split_particles == SplitParticles::where_needed &&
                    has_unequal_cells)
      , feed(scene,
             initial_configuration,
             density,
             law->initial_state(),
             feed_parameters)
      , box(*scene.nodes, geometry, walls)
      , mass_matrix(*scene.nodes, geometry, parameters.consistent_mass_share)
      , critical(*law, geometry, scene)
    {
      if (volumetric_average.is_on &&
          relieves_overfull_cells(
            parameters,
            feed_parameters,
            is_in_unequal_hexahedra(),
            !faces_with_role(scene.mesh, BoundaryRole::outlet).empty()))
        volumetric_average.overfull =
          std::make_unique<OverfullCells<Setting>>(*scene.nodes,
                                                   geometry,
                                                   cloud.blocks().cells(),
                                                   initial_configuration.points,
                                                   density,
                                                   scene.gravity.norm());
      seed_particles(scene.mesh,
                     initial_configuration,
                     density,
                     law->initial_state(),
                     cloud);
      sum_over_particles();
      if (parameters.has_automatic_time_step)
        {
          control.seeded_critical_time_step = find_critical_time_step();
          control.last_local_eigenvalue     = local_eigenvalue();
          control.seeded_local_eigenvalue   = control.last_local_eigenvalue;
        }
    }

    void
    step() override
    {
      // Steps 2 to 4: sums over the particles, left by the last pass
      begin(StepPart::mass_matrix);
      mass_matrix.assemble(cloud.blocks(), nodal_sums, fields.sums);
      begin(StepPart::time_step);
      time.time_step = this->choose_time_step();
      // Step 2: nodal velocity
      begin(StepPart::nodal_equations);
      solve_velocity(fields, *scene.nodes, mass_matrix);
      // Steps 4 and 5: contact and nodal acceleration
      solve_acceleration(fields,
                         *scene.nodes,
                         mass_matrix,
                         contact,
                         scene.gravity,
                         time.time_step,
                         [this](NodalField<dim> &acceleration) {
                           if (box.is_on)
                             plastic_dissipation += box.brake(cloud.blocks(),
                                                              nodal_sums,
                                                              fields.sums,
                                                              time.time_step,
                                                              acceleration);
                         });
      // Step 7: the velocity that deforms and moves the particles
      begin(StepPart::velocity_map);
      nodal_sums.map_momentum(cloud.blocks(),
                              fields.acceleration,
                              time.time_step,
                              fields.mapped_velocity);
      solve_mapped_velocity(fields, mass_matrix, contact, time.time_step);
      begin(StepPart::volumetric_strain);
      volumetric_average.compute(cloud.blocks(),
                                 nodal_sums,
                                 fields.mapped_velocity);
      // Steps 6, 8 and 9: velocity, stress, density and position
      begin(StepPart::particles);
      particle_steps += cloud.n_locally_owned_particles();
      pass_over_particles();
      begin(StepPart::relocation);
      if (outlets.is_on())
        outlets.count_removed(strays.parcels, geometry);
      const auto &arrivals = relocation.relocate(strays, cloud, time);
      for_each_sums([&](auto &cells) { cells.add(cloud.blocks(), arrivals); });
      contact.add_impulses(relocation.wall_impulses);
      begin(StepPart::splitting);
      if (splitting.is_on() && time.step % splitting.interval == 0)
        split_particles();
      if (feed.is_on() && !this->is_settling)
        feed_particles();
      begin(StepPart::sums_at_nodes);
      scatter_sums();
      // Step 10
      time.time += time.time_step;
      ++time.step;
      begin(StepPart::order);
      this->check_speed();
      cloud.change_blocks().sort_if_mixed();
      begin(StepPart::done);
    }

    Point<dim>
    initial_position(const types::particle_index id) const override
    {
      return initial_configuration.position(id);
    }

  private:
    static constexpr double automatic_pic_share = 0.003;

    using Stage::begin;
    using Stage::cloud;
    using Stage::contact;
    using Stage::control;
    using Stage::fields;
    using Stage::outlets;
    using Stage::parameters;
    using Stage::particle_steps;
    using Stage::plastic_dissipation;
    using Stage::removed;
    using Stage::scene;
    using Stage::time;

    /// In them particles gather, and light ones are thrown out
    /// (doc/three-dimensions.md).
    bool
    is_in_unequal_hexahedra() const
    {
      return Setting::cell_type == CellType::hexahedron && has_unequal_cells;
    }

    void
    pass_over_particles()
    {
      try
        {
          plastic_dissipation += law->pass(cloud.change_blocks(),
                                           fields.acceleration,
                                           fields.mapped_velocity,
                                           time,
                                           pic_share,
                                           nodal_sums,
                                           volumetric_average,
                                           strays);
        }
      catch (const LawFailure &failure)
        {
          throw_law_failure(describe(time) + failure.what(),
                            scene.communicator);
        }
    }

    /// Call `function(sums)` for the sums over particles in their cells.
    template <typename Function>
    void
    for_each_sums(const Function &function)
    {
      function(nodal_sums.cells);
      if (volumetric_average.cells)
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

    void
    feed_particles()
    {
      fed.clear();
      for (const Parcel &parcel :
           feed.due(cloud.blocks(), time, removed.discharged - this->mass_fed))
        {
          this->mass_fed += parcel.properties[Layout::mass];
          fed.push_back(cloud.insert(parcel));
        }
      for_each_sums([this](auto &cells) { cells.add(cloud.blocks(), fed); });
    }

    void
    sum_over_particles() override
    {
      for_each_sums([&](auto &cells) { cells.compute(cloud.blocks()); });
      scatter_sums();
    }

    void
    scatter_sums()
    {
      if (parameters.has_automatic_time_step)
        scatter_with_stiffness(fields.sums);
      else
        nodal_sums.scatter(cloud.blocks(), nullptr, fields.sums);
    }

    void
    scatter_with_stiffness(NodalSumField<dim> &sums) const
    {
      nodal_sums.scatter(
        cloud.blocks(),
        [this](const unsigned int cell) {
          return critical.cell_stiffness().elasticity(cell).confined_modulus();
        },
        sums);
    }

    std::vector<double>
    pack_cell_sums() const override
    {
      return Sandglass::pack_cell_sums(cloud.blocks(),
                                       nodal_sums,
                                       volumetric_average,
                                       changing_stiffness());
    }

    void
    unpack_cell_sums(const std::vector<double> &packed) override
    {
      Sandglass::unpack_cell_sums(packed,
                                  nodal_sums,
                                  volumetric_average,
                                  changing_stiffness());
      scatter_sums();
    }

    /// Of the cells; nullptr if the law's is constant.
    CellStiffness<Setting> *
    changing_stiffness() const
    {
      return law->has_constant_stiffness ? nullptr : &critical.cell_stiffness();
    }

    FlowTotals
    totals() const override
    {
      FlowTotals totals = sum_up<Setting>(cloud.blocks(),
                                          *law,
                                          removed,
                                          this->dissipation(),
                                          contact.wall_work(),
                                          particle_steps,
                                          scene.communicator);
      totals.mass_by_outlet =
        outlets.masses(cloud.blocks(), scene.communicator);
      if (feed.is_on())
        totals.mass_fed =
          Utilities::MPI::sum<double>(this->mass_fed, scene.communicator);
      return totals;
    }

    std::vector<StateVariable>
    state_variables() const override
    {
      return law->state_variables();
    }

    void
    set_initial_state(const InitialStateFunction<dim> &initial_state,
                      Parcel                          &particle) const override
    {
      const InitialState<dim> initial =
        initial_state(particle.cell, particle.reference_point);
      auto &state = particle.properties;
      std::copy_n(initial.stress.data(),
                  initial.stress.size(),
                  state.begin() + Layout::stress);
      state[Layout::density] = unstressed_density / initial.volume_ratio;
      if constexpr (Layout::n_law_numbers > 0)
        std::copy(initial.law_state.begin(),
                  initial.law_state.end(),
                  state.begin() + Layout::law_state);
      particle.location += initial.displacement;
      particle.reference_point =
        geometry.shape(particle.cell).to_reference(particle.location);
    }

    FedNumbers
    fed_numbers() const override
    {
      return feed.fed_numbers();
    }

    void
    set_fed_numbers(const FedNumbers &numbers) override
    {
      feed.set_fed_numbers(numbers);
    }

    void
    relocate_strays() override
    {
      using Block = ParticleBlock<Layout>;
      std::vector<ParticleSlot> slots;
      cloud.blocks().for_each([&](const ParticleSlot &slot) {
        const Point<dim> reference =
          cloud.blocks()[slot.block].point(Block::reference, slot.lane);
        if (!CellGeometry<Setting::cell_type>::is_inside(
              reference, Relocation<Setting>::margin))
          slots.push_back(slot);
      });
      strays.clear();
      // The order that ParticleBlocks::remove() asks for.
      for (auto slot = slots.rbegin(); slot != slots.rend(); ++slot)
        strays.add(*slot);
      strays.take_out(cloud.change_blocks());
      relocation.relocate(strays, cloud, time);
    }

    double
    find_critical_time_step() const override
    {
      // The result is within a few per cent of the eigenvalue, which the safety
      // factor covers.
      constexpr unsigned int n_iterations = 7;
      mass_matrix.assemble(cloud.blocks(), nodal_sums, fields.sums);
      critical.assemble(cloud.blocks(), nodal_sums);
      const auto compute = [this](const NodalSumField<dim> &sums) {
        return critical.compute(
          cloud.blocks(), nodal_sums, mass_matrix, contact, sums, n_iterations);
      };
      if (parameters.has_automatic_time_step && law->has_constant_stiffness)
        return compute(fields.sums);
      NodalSumField<dim> sums = fields.sums;
      scatter_with_stiffness(sums);
      return compute(sums);
    }

    double
    local_eigenvalue() const override
    {
      return critical.local_eigenvalue(fields.sums);
    }

    const CellGeometry<Setting::cell_type> geometry;
    const InitialConfiguration<Kinematics, Setting::cell_type>
                                     initial_configuration;
    const bool                       has_unequal_cells;
    const double                     pic_share; ///< see approach()
    const double                     unstressed_density;
    const std::unique_ptr<const Law> law;
    NodalSums<Setting>               nodal_sums;
    VolumetricAverage<Setting>       volumetric_average;
    Relocation<Setting>              relocation;
    ParticleSplitting<Setting>       splitting;
    Feed<Setting>                    feed;
    BoxFriction<Setting>             box;

    // What they know is found anew in each step, so a view may use them too.
    mutable MassMatrix<Setting>       mass_matrix;
    mutable CriticalTimeStep<Setting> critical;

    /// Kept between steps to avoid allocation.
    Strays<Layout>            strays;
    std::vector<ParticleSlot> fed;
  };
} // namespace Sandglass

#endif
