#include <sandglass/scene/gmsh_options.h>

#include <gmsh.h>

namespace Sandglass
{
  void
  set_gmsh_options(const SceneParameters &parameters)
  {
    using Algorithm = SceneParameters::MeshAlgorithm;
    const int algorithm =
      parameters.mesh_algorithm == Algorithm::frontal_delaunay ? 6 :
      parameters.mesh_algorithm == Algorithm::delaunay         ? 5 :
                                                                 1;
    gmsh::option::setNumber("Mesh.Algorithm", algorithm);
    gmsh::option::setNumber("Mesh.RandomSeed", parameters.mesh_seed);
  }
} // namespace Sandglass
