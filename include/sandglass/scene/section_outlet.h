#ifndef sandglass_scene_section_outlet_h
#define sandglass_scene_section_outlet_h

#include <sandglass/scene/mesh.h>
#include <sandglass/scene/scene_parameters.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * An outlet of a mesh: edges that hang together. Lengths in m, both halves
   * counted where the outlet ends at an axis.
   */
  struct SectionOutlet
  {
    double width = 0.;
    /// Length of the edges at its lips, the largest one; 0 if no wall ends
    /// there.
    double edge_at_lip = 0.;

    /// Cells across the outlet if all were as large as those at its lips,
    /// which is where coarse cells narrow the flow.
    double
    n_cells() const
    {
      return width / edge_at_lip;
    }
  };

  /// The outlets of a section.
  std::vector<SectionOutlet>
  section_outlets(const Mesh<2> &mesh);

  /**
   * Doubt a mesh whose cells are too large for its outlet: how many there are,
   * what error to expect, and what to set. A closed outlet needs none.
   *
   * @param warnings  takes the doubt.
   */
  template <int dim>
  void
  doubt_outlet(const SceneParameters    &parameters,
               const Mesh<dim>          &mesh,
               std::vector<std::string> &warnings);

  template <>
  void
  doubt_outlet<2>(const SceneParameters    &parameters,
                  const Mesh<2>            &mesh,
                  std::vector<std::string> &warnings);
} // namespace Sandglass

#endif
