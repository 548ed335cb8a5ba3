#include "mesh_file.h"

#include <gtest/gtest.h>

#include <iostream>

#include "rest.h"
#include "stage_fixture.h"

using namespace Sandglass;

namespace
{
  /// Mass in kg that leaves the silo of a mesh file in its first 0.4 s.
  double
  discharged(const MeshFile &file, const Formulation formulation)
  {
    StageFixture    fixture;
    SceneParameters scene;
    scene.formulation           = formulation;
    fixture.formulation         = formulation;
    fixture.parameters.end_time = 0.4;
    fixture.start(file.read(scene));
    start_from_rest(fixture);
    while (!fixture.stage->is_finished())
      fixture.stage->step();
    return discharged_mass(fixture.stage->view().totals());
  }
} // namespace



// Wherever the silo is drawn, and whatever the fall region's border is called.
// Rounding grows in the flow, and mass leaves by whole particles, each 0.4 % of
// it.
TEST(MeshFiles, AMovedMirroredOrOtherwiseNamedSiloFlowsTheSame)
{
  for (const Formulation formulation :
       {Formulation::plane_strain, Formulation::axisymmetric})
    {
      const MeshFile regular(0.1);
      MeshFile       moved = regular, left = regular, named = regular;
      moved.move([](auto &node) {
        node[0] += 2.;
        node[1] += 5.;
      });
      left.move([](auto &node) { node[0] = -3. - node[0]; });
      named.rename("fall_bottom", "fall_side");
      for (auto &element : named.elements)
        if (element.group == "axis" && named.nodes[element.nodes[0]][1] < 0.)
          element.group = "fall_side";

      const double mass = discharged(regular, formulation);
      EXPECT_GT(mass, 10.);
      for (const MeshFile *file : {&moved, &left, &named})
        {
          const double difference =
            std::abs(discharged(*file, formulation) / mass - 1.);
          std::cout << "difference of the discharged masses " << difference
                    << std::endl;
          EXPECT_LT(difference, 0.02);
        }
    }
}
