#ifndef sandglass_tests_benchmark_flowing_box_h
#define sandglass_tests_benchmark_flowing_box_h

#include <sandglass/flow/particle_in_cell/setting.h>
#include <sandglass/particles/cell_geometry.h>

#include "solid_fixture.h"

/**
 * A quarter of a square silo of 0.6 m width and 1.2 m height above a flat floor
 * with a square outlet of 0.2 m, in cubes or in tetrahedra. The material starts
 * with the stress that its weight gives it.
 */
template <typename Setting>
struct FlowingBox : SolidFixture
{
  using Geometry = Sandglass::CellGeometry<Setting::cell_type>;
  using Point    = dealii::Point<3>;
  using Role     = Sandglass::BoundaryRole;

  enum class Method
  {
    paper,    ///< with fixed steps, as the plain loop
    automatic ///< the defaults
  };

  /// @param n  cubes along half the width, in sixths of it.
  explicit FlowingBox(const unsigned int n, const Method method)
  {
    constexpr double half_width = 0.3, half_outlet = 0.1, height = 1.2,
                     depth = 0.1, headroom = 0.1;
    const double edge = half_width / (3 * n);
    Box          box;
    box.cell_type   = Setting::cell_type;
    box.lower       = Point(0., -depth, 0.);
    box.upper       = Point(half_width, height + headroom, half_width);
    box.n           = {{3 * n, 14 * n, 3 * n}};
    box.roles       = {{{{Role::axis, Role::wall}},
                        {{Role::fall_bottom, Role::top}},
                        {{Role::axis, Role::wall}}}};
    box.is_filled   = [](const Point &p) { return p[1] > 0. && p[1] < height; };
    box.is_left_out = [](const Point &p) {
      return p[1] < 0. && (p[0] > half_outlet || p[2] > half_outlet);
    };
    box.role_at_gap = [](const Point &p) {
      return p[1] > -1e-6 ? Role::floor : Role::fall_side;
    };

    // As many as Particles per cell = auto takes.
    particles_per_cell =
      Setting::cell_type == Sandglass::CellType::hexahedron ? 27 : 8;
    parameters.end_time = 1e3;
    if (method == Method::paper)
      {
        set_time_step(2e-3 * edge);
        parameters.volumetric_strain = Sandglass::VolumetricStrain::element;
        parameters.force_integration = Sandglass::ForceIntegration::particles;
        parameters.split_particles   = Sandglass::SplitParticles::never;
        walls.outlet_lip = Sandglass::WallParameters::OutletLip::floor;
      }
    start(box.mesh());
    geometry = std::make_unique<Geometry>(*scene);
    stage->start_from(
      [this](const unsigned int cell, const Point &reference_point) {
        return state_at_rest(geometry->shape(cell).to_real(reference_point)[1]);
      },
      {});
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
  Sandglass::InitialState<3>
  state_at_rest(const double y) const
  {
    constexpr double lateral_ratio = 0.5; // within the yield surface
    const double     weight =
      material.density * gravity.norm() * (scene->fill_top - y);
    const double lateral  = -lateral_ratio * weight;
    const double pressure = (1. + 2. * lateral_ratio) / 3. * weight;
    const double bulk_modulus =
      material.young_modulus / (3. * (1. - 2. * material.poisson_ratio));
    Sandglass::InitialState<3> state{};
    state.stress << lateral, -weight, lateral, 0., 0., 0.;
    state.volume_ratio = 1. - pressure / bulk_modulus;
    return state;
  }
};

#endif
