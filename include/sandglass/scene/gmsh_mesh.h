#ifndef sandglass_scene_gmsh_mesh_h
#define sandglass_scene_gmsh_mesh_h

#include <deal.II/base/point.h>

#include <array>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace Sandglass
{
  /// Keeps Gmsh open for a scope, with its messages silenced.
  class GmshSession
  {
  public:
    GmshSession();
    GmshSession(const GmshSession &) = delete;
    GmshSession &
    operator=(const GmshSession &) = delete;
    ~GmshSession();
  };

  /// Call Gmsh. Its exceptions are texts: they become std::runtime_error.
  template <typename Function>
  void
  call_gmsh(const Function &function)
  {
    try
      {
        function();
      }
    catch (const std::string &error)
      {
        throw std::runtime_error(error);
      }
  }

  /**
   * What Gmsh's current model holds, as it is: nothing is checked yet. Elements
   * are known by their corners; nodes between corners are left out.
   */
  struct GmshMesh
  {
    struct Element
    {
      /// Indices of `nodes`, in Gmsh's order.
      std::vector<unsigned int> corners;
      /// Gmsh's name of the type, as in "Triangle 6".
      std::string type;
      /// Names of the physical groups that hold it.
      std::set<std::string> groups;
    };

    std::vector<dealii::Point<3>> nodes; ///< in m
    /// Elements of each dimension, no two of one dimension with the same
    /// corners.
    std::array<std::vector<Element>, 4> elements;
    /// Names of the physical groups of each dimension; one without a name is
    /// called by its number.
    std::array<std::set<std::string>, 4> groups;
    /// Whether elements have nodes between their corners.
    bool is_of_higher_order = false;
  };

  /// Whether a group has no name but its number.
  bool
  is_nameless(const std::string &group);

  /// Read the current model.
  GmshMesh
  read_gmsh_model();
} // namespace Sandglass

#endif
