#ifndef sandglass_run_parameters_h
#define sandglass_run_parameters_h

#include <sandglass/base/exceptions.h>
#include <sandglass/element_test/element_test_parameters.h>
#include <sandglass/flow/flow_parameters.h>
#include <sandglass/flow/particle_in_cell/feed_parameters.h>
#include <sandglass/flow/particle_in_cell/particle_stage_parameters.h>
#include <sandglass/flow/updated_lagrangian/static_stage_parameters.h>
#include <sandglass/flow/updated_lagrangian/updated_lagrangian_parameters.h>
#include <sandglass/material/material_parameters.h>
#include <sandglass/output/output_parameters.h>
#include <sandglass/run/stop_parameters.h>
#include <sandglass/scene/gate_parameters.h>
#include <sandglass/scene/scene_parameters.h>
#include <sandglass/walls/wall_parameters.h>

namespace Sandglass
{
  /// All sections of the parameter file. Each declares itself when made.
  struct Parameters
  {
    SceneParameters             scene;
    MaterialParameters          material;
    WallParameters              walls;
    StaticStageParameters       static_stage;
    FlowParameters              flow;
    ParticleStageParameters     particle_stage;
    FeedParameters              feed;
    GateParameters              gates;
    StopParameters              stop;
    UpdatedLagrangianParameters updated_lagrangian;
    ElementTestParameters       element_test;
    OutputParameters            output;

    /// Checks between parameters; throws InputError.
    void
    check()
    {
      scene.check();
      material.check();
      walls.check();
      particle_stage.check();
      feed.check();
      gates.check();
      check_method();
      if (walls.box_depth > 0. &&
          scene.formulation != Formulation::plane_strain)
        throw InputError("Walls",
                         "Box depth",
                         std::to_string(walls.box_depth),
                         "allowed is 0 unless the formulation is plane strain");
      if (scene.formulation == Formulation::three_dimensions)
        check_in_space();
      else if (particle_stage.pic_share.value_or(0.) > 0.)
        throw InputError("Particle stage",
                         "PIC share",
                         std::to_string(*particle_stage.pic_share),
                         "two dimensions allow auto and 0");
      if (scene.is_filled_in_layers && !static_stage.is_enabled)
        throw InputError("Scene",
                         "Filling",
                         "in layers",
                         "allowed is at once with Static stage/Enabled = "
                         "false: layers settle at rest");
      element_test.check();
      output.check();
    }

    /// Give the sizes of cells that are `auto` the numbers chosen: see
    /// SceneParameters::fix_resolution().
    void
    fix_resolution()
    {
      const bool is_explicit =
        flow.method == FlowParameters::Method::particle_in_cell;
      scene.fix_resolution(is_explicit ? material.wave_speed() : 0.);
    }

  private:
    /// What is for the plane only.
    void
    check_in_space() const
    {
      if (flow.method == FlowParameters::Method::updated_lagrangian)
        throw InputError("Flow",
                         "Method",
                         "updated Lagrangian",
                         "three dimensions allow particle-in-cell");
      if (material.stress_rate == StressRate::green_naghdi)
        throw InputError("Material",
                         "Stress rate",
                         "Green-Naghdi",
                         "three dimensions allow Jaumann");
    }

    /// Refuse what only particles can do.
    void
    check_method() const
    {
      if (flow.method == FlowParameters::Method::particle_in_cell)
        return;
      if (feed.kind != FeedKind::none)
        throw InputError("Feed",
                         "Kind",
                         feed.kind == FeedKind::level ? "level" : "rain",
                         "allowed is none, unless Flow/Method = "
                         "particle-in-cell");
      if (scene.is_filled_in_layers)
        throw InputError("Scene",
                         "Filling",
                         "in layers",
                         "allowed is at once, unless Flow/Method = "
                         "particle-in-cell");
      if (gates.are_on())
        throw InputError("Gates",
                         "Openings",
                         to_text(*gates.openings.begin()),
                         "allowed are no gates, unless Flow/Method = "
                         "particle-in-cell");
    }
  };
} // namespace Sandglass

#endif
