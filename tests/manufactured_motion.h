#ifndef sandglass_tests_manufactured_motion_h
#define sandglass_tests_manufactured_motion_h

#include <cmath>

#include "divergence.h"
#include "stage_fixture.h"

/**
 * A motion x = X + phi(X) sin(omega t) of a unit square, or of a cylinder of
 * radius and height 1, between smooth walls all around, and the body force that
 * it needs in an elastic material with Jaumann's rate. The normal displacement
 * and the shear stress vanish at the walls.
 */
struct ManufacturedMotion
{
  /// Which form phi has.
  enum class Form
  {
    /**
     * phi = A (sin(pi X) cos(pi Y), cos(pi X) sin(pi Y) / 2), with shear and
     * rotation. Its body force is that of linear elasticity: what geometry
     * changes is the share A of it.
     */
    sheared,
    /**
     * phi = A (sin(pi X), -sin(pi Y)): no spin and principal axes that stay, so
     * that Jaumann's rate integrates to the logarithmic strain, and the body
     * force is exact for any amplitude.
     */
    axis_aligned
  };

  static constexpr double pi = dealii::numbers::PI;

  double
  angular_frequency() const
  {
    return pi * elasticity.wave_speed(density); // of a standing wave
  }

  dealii::Tensor<1, 2>
  shape(const dealii::Point<2> &X) const
  {
    if (form == Form::axis_aligned)
      return dealii::Tensor<1, 2>(
        {amplitude * std::sin(pi * X[0]), -amplitude * std::sin(pi * X[1])});
    return dealii::Tensor<1, 2>(
      {amplitude * std::sin(pi * X[0]) * std::cos(pi * X[1]),
       amplitude / 2. * std::cos(pi * X[0]) * std::sin(pi * X[1])});
  }

  dealii::Tensor<1, 2>
  displacement(const dealii::Point<2> &X, const double time) const
  {
    return std::sin(angular_frequency() * time) * shape(X);
  }

  dealii::Tensor<1, 2>
  velocity(const dealii::Point<2> &X, const double time) const
  {
    return angular_frequency() * std::cos(angular_frequency() * time) *
           shape(X);
  }

  /// Displacement gradient (xx, yy, hoop, mean of xy and yx).
  Sandglass::SymmetricComponents<4>
  gradient(const dealii::Point<2> &X, const double time) const
  {
    const double scale = pi * amplitude;
    const double sx = std::sin(pi * X[0]), cx = std::cos(pi * X[0]);
    const double sy = std::sin(pi * X[1]), cy = std::cos(pi * X[1]);
    Sandglass::SymmetricComponents<4> result;
    if (form == Form::axis_aligned)
      result << cx, -cy, 0., 0.;
    else
      result << cx * cy, cx * cy / 2., 0., -0.75 * sx * sy;
    result *= scale;
    if (formulation == Sandglass::Formulation::axisymmetric)
      result[Sandglass::Component::zz] = shape(X)[0] / X[0];
    return std::sin(angular_frequency() * time) * result;
  }

  /// Cauchy stress beside the initial pressure, in Pa.
  Sandglass::SymmetricComponents<4>
  stress(const dealii::Point<2> &X, const double time) const
  {
    Sandglass::SymmetricComponents<4> strain = gradient(X, time);
    for (const unsigned int c : {0, 1, 2})
      strain[c] = std::log1p(strain[c]);
    return elasticity.stress(strain);
  }

  /// Force per mass in m/s^2 on the particle that was at X. An even pressure
  /// adds nothing to it.
  dealii::Tensor<1, 2>
  body_force(const dealii::Point<2> &X, const double time) const
  {
    const auto stress_at = [&](const dealii::Point<2> &point) {
      return piola_stress(point, time);
    };
    const dealii::Tensor<1, 2> divergence =
      divergence_of(stress_at, X, formulation);
    const double omega = angular_frequency();
    return -omega * omega * displacement(X, time) - divergence / density;
  }

  Sandglass::Formulation formulation;
  Form                   form;
  double                 amplitude; ///< in m
  Sandglass::Elasticity  elasticity{1e6, 0.3};
  double                 density = 1500.;

private:
  /// First Piola-Kirchhoff stress J sigma F^-T, whose divergence is taken in
  /// the initial configuration; of the sheared motion without the terms in A^2.
  Sandglass::SymmetricComponents<4>
  piola_stress(const dealii::Point<2> &X, const double time) const
  {
    namespace C                               = Sandglass::Component;
    Sandglass::SymmetricComponents<4>       P = stress(X, time);
    const Sandglass::SymmetricComponents<4> H = gradient(X, time);
    const double fx = 1. + H[C::xx], fy = 1. + H[C::yy], fz = 1. + H[C::zz];
    P[C::xx] *= fy * fz;
    P[C::yy] *= fx * fz;
    P[C::zz] *= fx * fy;
    return P;
  }
};



/// Root mean squares over the particles' masses, relative to those of what they
/// are errors of.
struct MotionErrors
{
  double displacement, stress;
};



/**
 * The particle stage driven by the body force of a ManufacturedMotion.
 *
 * The force comes as a change of each particle's velocity before the step, as
 * step 6 would make it, so that the stage needs no part for it. Velocities
 * belong to the middle between two steps, so they start half a step early.
 */
class ManufacturedRun
{
public:
  /// Courant number C dt / h, with the squares' side h.
  static constexpr double courant_number = 0.3;

  /// @param relative_pressure  over the largest uniaxial stress; less than 1.6
  ///                           doesn't keep the material elastic.
  ManufacturedRun(const ManufacturedMotion         &motion,
                  const Sandglass::CellType         cell_type,
                  const Sandglass::ForceIntegration integration,
                  const unsigned int                n_cells,
                  const unsigned int                particles_per_cell,
                  const double                      relative_pressure = 2.)
    : motion(motion)
    // An even pressure that keeps the material within the cone
    , initial_pressure(relative_pressure * motion.pi * motion.amplitude *
                       motion.elasticity.confined_modulus())
  {
    using namespace Sandglass;
    fixture.formulation                      = motion.formulation;
    fixture.gravity                          = {};
    fixture.particles_per_cell               = particles_per_cell;
    fixture.material.density                 = motion.density;
    fixture.material.internal_friction_angle = 85.;
    // The others would separate what is less dense than at the start.
    fixture.parameters.density_update = DensityUpdate::paper;
    // The finite motion's strains are large enough for it to matter.
    fixture.parameters.stress_integration = StressIntegration::middle_of_step;
    fixture.parameters.force_integration  = integration;
    // What the bounds and doc/verification.md are of; averaging smooths the
    // exact solution's strain as well.
    fixture.parameters.volumetric_strain = VolumetricStrain::element;

    // Three eighths of a period: neither velocity nor displacement vanishes.
    const double end = 0.75 * motion.pi / motion.angular_frequency();
    n_steps          = static_cast<unsigned int>(
      std::ceil(end * motion.elasticity.wave_speed(motion.density) * n_cells /
                courant_number));
    fixture.parameters.end_time = end;
    fixture.set_time_step(end / n_steps);

    Rectangle rectangle;
    rectangle.cell_type = cell_type;
    rectangle.n_x = rectangle.n_y = n_cells;
    rectangle.left = rectangle.right = BoundaryRole::axis;
    rectangle.bottom = rectangle.top = BoundaryRole::axis;
    fixture.start(rectangle.mesh());
    fixture.stage->start_from(
      [this](const unsigned int, const dealii::Point<2> &) {
        return Sandglass::InitialState<2>{
          {}, SymmetricComponents<4>(isotropic<4>(-initial_pressure)), 1.};
      },
      {});
    change_velocities([&](const dealii::Point<2> &X) {
      return this->motion.velocity(X, -end / n_steps / 2.);
    });
  }

  MotionErrors
  run()
  {
    auto &stage = *fixture.stage;
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        const double time      = stage.view().clock().time;
        const double time_step = fixture.parameters.end_time / n_steps;
        change_velocities([&](const dealii::Point<2> &X) {
          return time_step * motion.body_force(X, time);
        });
        stage.step();
      }
    return errors();
  }

  StageFixture fixture;

private:
  template <typename Change>
  void
  change_velocities(const Change &change)
  {
    constexpr unsigned int velocity =
      Sandglass::ParticleBlock<StageLayout>::velocity;
    fixture.stage->edit_blocks([&](auto &blocks) {
      blocks.for_each([&](const Sandglass::ParticleSlot &slot) {
        const dealii::Tensor<1, 2> difference =
          change(fixture.stage->initial_position(blocks.id(slot)));
        for (unsigned int d = 0; d < 2; ++d)
          blocks[slot.block].values[velocity + d][slot.lane] += difference[d];
      });
    });
  }

  MotionErrors
  errors() const
  {
    using namespace Sandglass;
    const double time = fixture.stage->view().clock().time;
    MotionErrors result{};
    double       displacement_scale = 0., stress_scale = 0.;
    fixture.for_each_particle([&](auto id, const auto &position, auto state) {
      const dealii::Point<2>       X     = fixture.stage->initial_position(id);
      const double                 m     = state[StageLayout::mass];
      const dealii::Tensor<1, 2>   u     = motion.displacement(X, time);
      const SymmetricComponents<4> exact = motion.stress(X, time);
      SymmetricComponents<4>       difference =
        isotropic<4>(initial_pressure) - exact;
      for (unsigned int c = 0; c < 4; ++c)
        difference[c] += state[StageLayout::stress + c];
      result.displacement += m * (position - X - u).norm_square();
      displacement_scale += m * u.norm_square();
      result.stress += m * double_contraction(difference, difference);
      stress_scale += m * double_contraction(exact, exact);
    });
    result.displacement = std::sqrt(result.displacement / displacement_scale);
    result.stress       = std::sqrt(result.stress / stress_scale);
    return result;
  }

  const ManufacturedMotion motion;
  const double             initial_pressure; ///< in Pa
  unsigned int             n_steps;
};

#endif
