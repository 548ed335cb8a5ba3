#ifndef sandglass_tests_benchmark_flowing_silo_h
#define sandglass_tests_benchmark_flowing_silo_h

#include <sandglass/flow/particle_in_cell/cell_kernel.h>
#include <sandglass/flow/particle_in_cell/setting.h>
#include <sandglass/scene/make_mesh.h>

#include "stage_fixture.h"

/**
 * The flat-bottomed silo of prm/paper/plane-flat-bottom-mesh-3.prm, plane or
 * axisymmetric, of triangles or quadrilaterals, and on finer meshes. The
 * material starts at rest, with the stress that its weight gives it. The time
 * step is the paper's, in proportion to the element size, if it isn't
 * automatic.
 */
template <typename Setting>
struct FlowingSilo : StageFixture
{
  using Geometry = Sandglass::CellGeometry<Setting::cell_type>;
  using Point    = dealii::Point<2>;

  /// Choices of strain, force, splitting and lip, and of time steps.
  enum class Method
  {
    paper,
    program,  ///< the defaults, with the paper's steps
    automatic ///< the defaults
  };

  /// @param refinement  how often the elements of mesh 3 go into its edges.
  explicit FlowingSilo(const unsigned int refinement,
                       const Method       method = Method::paper)
  {
    Sandglass::SceneParameters silo;
    silo.formulation  = Setting::Kinematics::formulation;
    silo.cell_type    = Setting::cell_type;
    silo.element_size = 0.025 / refinement;
    formulation       = silo.formulation;

    if (method != Method::automatic)
      set_time_step(0.01 * *silo.element_size); // Tables II, IV
    parameters.end_time = 1e3;
    if (method == Method::paper) // and of the plain loop
      {
        parameters.volumetric_strain = Sandglass::VolumetricStrain::element;
        parameters.force_integration = Sandglass::ForceIntegration::particles;
        parameters.split_particles   = Sandglass::SplitParticles::never;
        walls.outlet_lip = Sandglass::WallParameters::OutletLip::floor;
      }
    start(Sandglass::make_mesh<2>(silo, MPI_COMM_WORLD));
    geometry = std::make_unique<Geometry>(*scene);
    stage->start_from(
      [this](const unsigned int cell, const Point &reference_point) {
        return state_at_rest(geometry->shape(cell).to_real(reference_point)[1]);
      },
      {});
  }

  /// Take over the velocity of the flow on a coarser mesh.
  void
  take_velocity(const FlowingSilo &coarse)
  {
    unsigned int cell = 0;
    stage->edit_particles([&](auto &handler) {
      for (auto &particle : handler)
        {
          const auto place =
            coarse.geometry->find(particle.get_location(), cell);
          cell                = place.cell;
          const auto velocity = Sandglass::interpolate(
            Sandglass::gather(coarse.stage->nodal_fields().mapped_velocity,
                              coarse.geometry->nodes(cell)),
            Geometry::Shape::shape_values(
              Sandglass::components_of<2>(place.reference_point)));
          std::copy(velocity.begin(),
                    velocity.end(),
                    particle.get_properties().begin() + StageLayout::velocity);
        }
    });
  }

  void
  run(const unsigned int n_steps)
  {
    for (unsigned int n = 0; n < n_steps; ++n)
      stage->step();
  }

  unsigned int
  n_particles() const
  {
    return stage->particles().n_locally_owned_particles();
  }

  std::unique_ptr<Geometry> geometry;

private:
  /// @param y  height in m.
  Sandglass::InitialState<2>
  state_at_rest(const double y) const
  {
    constexpr double lateral_ratio = 0.5; // within the yield surface
    const double     weight =
      material.density * gravity.norm() * (scene->fill_top - y);
    const double lateral  = -lateral_ratio * weight;
    const double pressure = (1. + 2. * lateral_ratio) / 3. * weight;
    const double bulk_modulus =
      material.young_modulus / (3. * (1. - 2. * material.poisson_ratio));
    return {{}, {lateral, -weight, lateral, 0.}, 1. - pressure / bulk_modulus};
  }
};

#endif
