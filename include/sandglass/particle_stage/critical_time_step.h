#ifndef sandglass_particle_stage_critical_time_step_h
#define sandglass_particle_stage_critical_time_step_h

#include <deal.II/base/mpi.h>

#include <sandglass/material/elasticity.h>
#include <sandglass/particle_stage/deformation.h>
#include <sandglass/particle_stage/random_nodal_field.h>
#include <sandglass/scene/scene.h>

#include <vector>

namespace Sandglass
{
  /**
   * The largest stable time step for the particles' present positions: what the
   * paper's eq. 17 is in one dimension and for one element, for the whole grid.
   *
   * One step takes the nodal velocity from v to v + dt G f with
   * G = M^-1 M_c M^-1, where M is the lumped mass matrix and M_c = S^T M_d S
   * the consistent one, which the velocity map of eq. 18 brings in, and f = -K
   * u with the elastic stiffness K. It is stable for dt^2 lambda <= 4, where
   * lambda is the largest eigenvalue of G K. A node that loses its mass does
   * not make lambda grow without bound, as it does without the velocity map.
   *
   * Power iteration finds lambda, with the Rayleigh quotient
   * (f^T G f) / (u^T f), which is never above it. It starts afresh from the
   * same random vector each time: the stiffest spot moves, and a restarted run
   * has to find the same step.
   *
   * Nodes on the axis of axisymmetric scenes don't leave it. If they did, a
   * particle's hoop strain would grow without bound as it nears the axis.
   *
   * Particles without stress that are less dense than `stiff_share` of the
   * unstressed material are separated; they don't count.
   */
  template <typename Setting>
  class CriticalTimeStep
  {
  public:
    static constexpr unsigned int n_nodes = Setting::nodes_per_cell;
    using Shape                           = CellShape<Setting::cell_type>;
    using Geometry                        = CellGeometry<Setting::cell_type>;

    static constexpr double stiff_share = 0.95;

    /// On plane triangles all particles of a cell deform alike.
    static constexpr bool is_uniform =
      Setting::has_constant_gradients && !Setting::has_hoop_strain;

    CriticalTimeStep(const Elasticity &elasticity,
                     const double      unstressed_density,
                     const Scene      &scene)
      : elasticity(elasticity)
      , smallest_density(stiff_share * unstressed_density)
      , scene(scene)
      , random_direction(*scene.nodes)
      , direction(*scene.nodes)
      , force(*scene.nodes)
      , mapped_force(*scene.nodes)
    {
      fill_with_random_numbers(random_direction, scene);
      if constexpr (Setting::has_hoop_strain)
        {
          find_nodes_on_axis();
          hold_on_axis(random_direction);
        }
    }

    /**
     * @param sums  of the particles' present positions; only masses are used.
     * @return the critical step in s, infinity if nothing is stiff. Collective.
     */
    double
    compute(ParticleCloud                            &cloud,
            const Geometry                           &geometry,
            const NodalField<NodalSum::n_components> &sums,
            const unsigned int                        n_iterations)
    {
      direction         = random_direction;
      double eigenvalue = 0.;
      for (unsigned int i = 0; i < n_iterations; ++i)
        eigenvalue = iterate(cloud, geometry, sums);
      return 2. / std::sqrt(eigenvalue);
    }

  private:
    /// One power iteration; returns the Rayleigh quotient in 1/s^2.
    double
    iterate(ParticleCloud                            &cloud,
            const Geometry                           &geometry,
            const NodalField<NodalSum::n_components> &sums)
    {
      const double energy = apply_stiffness(cloud, geometry);
      scale_by_mass(sums, 1., force);
      const double mapped_energy = apply_consistent_mass(cloud, geometry);

      const Tensor<1, 2> totals =
        Utilities::MPI::sum(Tensor<1, 2>({energy, mapped_energy}),
                            scene.communicator);
      if (!(totals[0] > 0.) || !(totals[1] > 0.))
        return 0.; // nothing is stiff
      // Keeps the eigenvector's size.
      scale_by_mass(sums, totals[0] / totals[1], mapped_force);
      std::swap(direction, mapped_force);
      return totals[1] / totals[0];
    }

    /// force = K direction; returns this rank's share of u^T K u.
    double
    apply_stiffness(ParticleCloud &cloud, const Geometry &geometry)
    {
      double energy = 0.;
      force.start_sum();
      for_each_filled_cell(
        cloud,
        geometry,
        [this, &energy](const unsigned int,
                        const Shape &shape,
                        const auto  &nodes,
                        const auto  &particles) {
          const auto               displacements = gather(direction, nodes);
          CellValues<dim, n_nodes> forces{};
          if constexpr (is_uniform)
            {
              double volume = 0.;
              for (const auto &particle : particles)
                volume += stiff_volume(particle);
              add_elastic_force(shape, displacements, {}, 1., volume, forces);
            }
          else
            for (const auto &particle : particles)
              add_elastic_force(shape,
                                displacements,
                                particle.get_reference_location(),
                                particle.get_location()[0],
                                stiff_volume(particle),
                                forces);
          for (unsigned int i = 0; i < n_nodes; ++i)
            for (unsigned int d = 0; d < dim; ++d)
              energy += forces[i][d] * displacements[i][d];
          scatter(forces, nodes, force);
        });
      force.finish_sum();
      return energy;
    }

    /// Volume of a particle that carries stress, in m^3, otherwise 0.
    template <typename Particle>
    double
    stiff_volume(const Particle &particle) const
    {
      const double *state    = particle.get_properties().data();
      const double  density  = state[Property::density];
      const bool    is_stiff = density >= smallest_density ||
                            state[Property::stress + Component::yy] != 0.;
      return is_stiff ? state[Property::mass] / density : 0.;
    }

    void
    add_elastic_force(const Shape                    &shape,
                      const CellValues<dim, n_nodes> &displacements,
                      const Point<dim>               &reference,
                      const double                    radius,
                      const double                    volume,
                      CellValues<dim, n_nodes>       &forces) const
    {
      const auto                 values    = Shape::shape_values(reference);
      const auto                 gradients = shape.shape_gradients(reference);
      const double               hoop      = Setting::has_hoop_strain ?
                                               interpolate(displacements, values)[0] / radius :
                                               0.;
      const DeformationIncrement deformation(gradient_of(displacements,
                                                         gradients),
                                             hoop);
      const SymmetricTensor4     stress =
        volume * elasticity.stress(deformation.strain);
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          forces[i][0] += stress[Component::xx] * gradients[i][0] +
                          stress[Component::xy] * gradients[i][1];
          forces[i][1] += stress[Component::xy] * gradients[i][0] +
                          stress[Component::yy] * gradients[i][1];
          if constexpr (Setting::has_hoop_strain)
            forces[i][0] += stress[Component::zz] * values[i] / radius;
        }
    }

    /// field = scale M^-1 field, ghosts updated.
    void
    scale_by_mass(const NodalField<NodalSum::n_components> &sums,
                  const double                              scale,
                  NodalField<dim>                          &field) const
    {
      for (unsigned int node = 0; node < scene.nodes->locally_owned_size();
           ++node)
        {
          const double mass = sums.at(node)[NodalSum::mass];
          for (unsigned int d = 0; d < dim; ++d)
            field.at(node)[d] =
              mass > 0. ? scale * field.at(node)[d] / mass : 0.;
        }
      hold_on_axis(field);
    }

    void
    find_nodes_on_axis()
    {
      for (const auto &cell : scene.dof_handler.active_cell_iterators())
        for (const unsigned int face : cell->face_indices())
          if (!cell->is_artificial() && cell->at_boundary(face) &&
              cell->face(face)->boundary_id() ==
                boundary_id(BoundaryRole::axis))
            for (const unsigned int v : {0u, 1u})
              {
                const auto dof = cell->face(face)->vertex_dof_index(v, 0);
                if (scene.nodes->in_local_range(dof))
                  nodes_on_axis.push_back(scene.nodes->global_to_local(dof));
              }
    }

    /// Updates ghosts.
    void
    hold_on_axis(NodalField<dim> &field) const
    {
      for (const unsigned int node : nodes_on_axis)
        field.at(node)[0] = 0.;
      field.update_ghosts();
    }

    /// mapped_force = M_c force; returns this rank's share of f^T M_c f.
    double
    apply_consistent_mass(ParticleCloud &cloud, const Geometry &geometry)
    {
      double energy = 0.;
      mapped_force.start_sum();
      for_each_filled_cell(cloud,
                           geometry,
                           [this, &energy](const unsigned int,
                                           const Shape &,
                                           const auto &nodes,
                                           const auto &particles) {
                             const auto accelerations = gather(force, nodes);
                             CellValues<dim, n_nodes> mapped{};
                             for (const auto &particle : particles)
                               {
                                 const double mass =
                                   particle.get_properties()[Property::mass];
                                 const auto values = Shape::shape_values(
                                   particle.get_reference_location());
                                 const Tensor<1, dim> acceleration =
                                   interpolate(accelerations, values);
                                 energy += mass * acceleration.norm_square();
                                 for (unsigned int i = 0; i < n_nodes; ++i)
                                   for (unsigned int d = 0; d < dim; ++d)
                                     mapped[i][d] +=
                                       mass * values[i] * acceleration[d];
                               }
                             scatter(mapped, nodes, mapped_force);
                           });
      mapped_force.finish_sum();
      return energy;
    }

    const Elasticity elasticity;
    const double     smallest_density;
    const Scene     &scene;

    /// Only in axisymmetric scenes.
    std::vector<unsigned int> nodes_on_axis;

    NodalField<dim> random_direction;
    NodalField<dim> direction;    ///< u, the eigenvector's approximation
    NodalField<dim> force;        ///< K u, then M^-1 K u
    NodalField<dim> mapped_force; ///< M_c M^-1 K u
  };
} // namespace Sandglass

#endif
