#ifndef sandglass_flow_particle_in_cell_particle_stage_parameters_h
#define sandglass_flow_particle_in_cell_particle_stage_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <sandglass/continuum/stress_integration.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Sandglass
{
  /// How the density, and with it a particle's volume, follows the flow.
  enum class DensityUpdate
  {
    paper,     ///< density / Jacobian, without bounds (Section 4.4, step 8)
    separation ///< the paper's; stress only while denser than the material's
  };

  /// Over which volume a cell's stress is integrated to nodal forces.
  enum class ForceIntegration
  {
    particles, ///< the particles' volumes, as in the paper
    cell       ///< the cell's own, where particles fill it
  };

  /// Which change of volume a stressed particle feels.
  enum class VolumetricStrain
  {
    element, ///< that of v^L in its cell, as in the paper
    averaged ///< over its cell's neighbours, against locking
  };

  /// When particles that are too large for their cell are halved.
  enum class SplitParticles
  {
    never,       ///< as in the paper
    where_needed ///< in meshes whose cells differ much in volume
  };

  /// Where cells in which too many particles have gathered are relieved.
  enum class RelieveOverfullCells
  {
    automatic, ///< where fed, and in unequal hexahedra while an outlet is open
    never,     ///< as in the paper
    where_fed, ///< in silos that are kept full, while an outlet is open
    always
  };

  /// Section `Particle stage`: the explicit particle-in-cell stage.
  class ParticleStageParameters : public dealii::ParameterAcceptor
  {
  public:
    ParticleStageParameters();

    enum class OnLostParticle
    {
      hold, ///< at the grid's top, and stop elsewhere
      stop,
      remove
    };

    double       end_time           = 2.5; ///< in s
    std::string  time_step_text     = "auto";
    double       time_step_safety   = 0.8;
    unsigned int time_step_interval = 50;
    /// alpha of the mass matrix alpha M + (1 - alpha) M_I (Section 3)
    double               consistent_mass_share = 0.;
    VolumetricStrain     volumetric_strain     = VolumetricStrain::averaged;
    StressIntegration    stress_integration = StressIntegration::start_of_step;
    ForceIntegration     force_integration  = ForceIntegration::cell;
    DensityUpdate        density_update     = DensityUpdate::separation;
    double               loosest_density    = 0.97;
    SplitParticles       split_particles    = SplitParticles::where_needed;
    RelieveOverfullCells relieve_overfull_cells =
      RelieveOverfullCells::automatic;
    /// Of PIC in the update of the particles' velocity; none: as the program
    /// chooses.
    std::optional<double> pic_share;
    OnLostParticle        on_lost_particle = OnLostParticle::hold;
    double                largest_speed    = 10.;

    /// Whether the step follows the critical step instead of a table.
    bool has_automatic_time_step = true;
    /// Start times and steps in s, in order of time; empty if automatic.
    std::vector<std::pair<double, double>> time_steps;

    /// Steps after which the automatic step is found anew.
    unsigned int
    automatic_step_interval() const;

    /// Throws InputError where the time step can't be read.
    void
    check();
  };
} // namespace Sandglass

#endif
