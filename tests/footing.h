#ifndef sandglass_tests_footing_h
#define sandglass_tests_footing_h

#include <sandglass/material/circular_cone.h>

#include <algorithm>
#include <cmath>

#include "stage_fixture.h"

/**
 * Half of a strip footing on a layer of material. The topmost row of cells is
 * the load: beside the footing its particles are so heavy that they make the
 * surcharge, and those of the footing become heavier still, slowly. The
 * material below is so light that its own weight, 6 % of the surcharge at the
 * bottom, matters little. The formula's stresses belong to an even load.
 */
class Footing
{
public:
  static constexpr double half_width = 0.5, width = 2.5, depth = 1.5; // m
  static constexpr double gravity = 1., density = 40.; // m/s^2, kg/m^3
  static constexpr double surcharge = 1000.;           // Pa
  /// Angle of the cone, so small that the material's strength hardly changes
  /// within the mechanism.
  static constexpr double friction_angle = 5.; // degrees

  /**
   * Pressure over surcharge at which a strip footing on weightless material
   * fails, by Prandtl and Reissner:
   *
   *     N_q = exp(pi tan phi) (1 + sin phi) / (1 - sin phi).
   *
   * Plane flow that keeps the volume has an out-of-plane stress midway between
   * the others, so that the cone is Coulomb's law with sin phi = m / sqrt(3).
   * The formula is for associated flow; flow that keeps the volume may carry
   * less, but by Davis' estimate, tan phi* = sin phi, only 0.3 % at this angle.
   */
  static double
  limit()
  {
    constexpr double pi   = dealii::numbers::PI;
    const double     sine = Sandglass::CircularCone(Sandglass::YieldCone::paper,
                                                friction_angle * pi / 180.,
                                                0.)
                          .slope /
                        std::sqrt(3.);
    const double tangent = sine / std::sqrt(1. - sine * sine);
    return std::exp(pi * tangent) * (1. + sine) / (1. - sine);
  }

  /// What the mesh is made of. Triangles with alternating diagonals hardly
  /// lock, those with parallel ones do.
  enum class Cells
  {
    alternating_triangles,
    parallel_triangles,
    quadrilaterals
  };

  /// @param n_cells  in the footing's half width.
  Footing(const Cells                       cells,
          const Sandglass::VolumetricStrain volumetric_strain,
          const unsigned int                n_cells,
          const Sandglass::ForceIntegration integration =
            Sandglass::ForceIntegration::particles)
    : h(half_width / n_cells)
  {
    using namespace Sandglass;
    fixture.gravity          = dealii::Tensor<1, 2>({0., -gravity});
    fixture.material.density = density;
    fixture.material.internal_friction_angle = friction_angle;
    fixture.parameters.volumetric_strain     = volumetric_strain;
    fixture.parameters.force_integration     = integration;
    fixture.parameters.density_update        = DensityUpdate::paper;
    fixture.parameters.end_time              = 1e3;
    Rectangle rectangle;
    rectangle.cell_type              = cells == Cells::quadrilaterals ?
                                         CellType::quadrilateral :
                                         CellType::triangle;
    rectangle.has_parallel_diagonals = cells == Cells::parallel_triangles;
    rectangle.n_x                    = std::lround(width / h);
    rectangle.n_y                    = std::lround(depth / h) + 2;
    rectangle.upper                  = dealii::Point<2>(width, depth + 2. * h);
    rectangle.is_filled              = [](const dealii::Point<2> &center) {
      return center[1] < depth;
    };
    rectangle.left = rectangle.right = BoundaryRole::axis; // smooth
    rectangle.bottom                 = BoundaryRole::axis;
    fixture.start(rectangle.mesh());
    set_stress();
    set_masses(surcharge, false);
    set_load(1.);
  }

  /**
   * Increase the pressure to the surcharge plus `share` of the difference to
   * the limit, and wait. Before it fails the footing settles by 0.2 % of its
   * width, and comes to rest within a second; when it fails it sinks by a third
   * of its width or more.
   *
   * @return whether it settles by less than 1 % of its width.
   */
  bool
  carries(const double share)
  {
    constexpr double loading_time = 2., waiting_time = 4.; // s
    auto            &stage = *fixture.stage;
    while (stage.view().clock().time < loading_time + waiting_time)
      {
        const double time_share =
          std::min(1., stage.view().clock().time / loading_time);
        set_load(1. + time_share * share * (limit() - 1.));
        stage.step();
        if (stage.view().clock().step % 100 == 0 && settlement() > 0.01)
          return false;
      }
    return true;
  }

  const double h; ///< the squares' side, m
  StageFixture fixture;

private:
  bool
  is_on_top(const dealii::types::particle_index id) const
  {
    return fixture.stage->initial_position(id)[1] > depth - h;
  }

  bool
  is_footing(const dealii::types::particle_index id) const
  {
    return is_on_top(id) && fixture.stage->initial_position(id)[0] < half_width;
  }

  /// Even pressure of surcharge and weight, growing from zero in the row on
  /// top.
  void
  set_stress()
  {
    fixture.change_particles([&](auto, const auto &position, auto state) {
      const double below = depth - h - position[1];
      const double p     = below > 0. ? surcharge + density * gravity * below :
                                        surcharge * (depth - position[1]) / h;
      for (const unsigned int c : {0, 1, 2})
        state[StageLayout::stress + c] = -p;
    });
  }

  /// Give the particles of the row on top, within the footing or beside it,
  /// the mass of a pressure. Their density grows too, so that their volume
  /// stays.
  void
  set_masses(const double pressure, const bool of_footing)
  {
    using Block = Sandglass::ParticleBlock<StageLayout>;
    fixture.stage->edit_blocks([&](auto &blocks) {
      blocks.for_each([&](const Sandglass::ParticleSlot &slot) {
        const auto id = blocks.id(slot);
        if (!is_on_top(id) || is_footing(id) != of_footing)
          return;
        auto        &values = blocks[slot.block].values;
        const double factor =
          pressure / (gravity * h) / values[Block::density][slot.lane];
        values[Block::mass][slot.lane] *= factor;
        values[Block::density][slot.lane] *= factor;
      });
    });
  }

  void
  set_load(const double load)
  {
    set_masses(load * surcharge, true);
  }

  double
  settlement() const
  {
    double       sum = 0.;
    unsigned int n   = 0;
    fixture.for_each_particle([&](auto id, const auto &position, auto) {
      if (is_footing(id))
        {
          sum += fixture.stage->initial_position(id)[1] - position[1];
          ++n;
        }
    });
    return sum / n / (2. * half_width);
  }
};

#endif
