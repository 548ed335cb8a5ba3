#ifndef sandglass_flow_updated_lagrangian_settled_layers_h
#define sandglass_flow_updated_lagrangian_settled_layers_h

#include <sandglass/flow/updated_lagrangian/static_state.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// Layers at rest, on which another one is placed; complete on all ranks.
  template <int dim>
  struct SettledLayers
  {
    /// At the vertices of the scene's mesh, as many numbers as directions:
    /// displacement in m, and what the nodes carry of the weight in N.
    std::vector<double> displacement, weight;

    /// Of each cell of the scene, at its quadrature points in the order of its
    /// vertices; empty where nothing is.
    struct Point
    {
      std::vector<double> stress; ///< in Pa
      double              volume_ratio;
      std::vector<double> law_state;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &stress &volume_ratio &law_state;
      }
    };

    std::vector<std::vector<Point>> points;

    /// What WallContact has saved.
    std::string contact;

    StaticEffort effort;
  };
} // namespace Sandglass

#endif
