#ifndef sandglass_output_section_wall_corners_h
#define sandglass_output_section_wall_corners_h

#include <sandglass/flow/flow_view.h>
#include <sandglass/scene/mesh.h>

#include <vector>

namespace Sandglass
{
  /**
   * The nodes that several walls of a section hold: at kinks, in corners, and
   * where a wall goes on in the same plane under another name; and those that a
   * wall and the axis hold together.
   */
  class WallCorners
  {
  public:
    /// A straight part of one wall from a corner on: its records in order.
    struct Run
    {
      std::vector<unsigned int> records;
      bool                      ends_in_corner = false;

      /// How many nodes beside the corner are no corners themselves.
      unsigned int
      n_between() const
      {
        return records.size() - (ends_in_corner ? 2 : 1);
      }
    };

    struct Corner
    {
      std::vector<Run> runs;
      /// On the axis its direction, else zero.
      Tensor<1, 2> axis;

      bool
      is_on_axis() const
      {
        return axis.norm_square() > 0.;
      }
    };

    /// @param records  of all nodes of the walls.
    WallCorners(const Mesh<2>                 &mesh,
                const std::vector<Wall<2>>    &walls,
                const std::vector<WallRecord> &records);

    std::vector<Corner> corners;
    /// The outward normals of the walls' faces at the records' nodes. The
    /// record's own differs on the axis, where a wall may act along it only.
    std::vector<Tensor<1, 2>> normals;
  };
} // namespace Sandglass

#endif
