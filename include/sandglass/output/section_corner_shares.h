#ifndef sandglass_output_section_corner_shares_h
#define sandglass_output_section_corner_shares_h

#include <sandglass/output/section_wall_corners.h>

#include <vector>

namespace Sandglass
{
  /**
   * What each wall has of the forces where walls of a section meet.
   *
   * There, the walls together hold one node, by one force. That force is right,
   * but neither contact nor equilibrium says how much of it is whose: it may
   * all be recorded with one of them, and a node that slides along one wall
   * unloads the next nodes of the other. So the force is shared out by what the
   * walls bear beside the corner: tractions are continued linearly along each
   * of them, and then corrected so that forces add up to what was recorded.
   *
   * A small correction is that of the corner alone. A larger one fades out over
   * the next two nodes, the first of which may be continued like the corner:
   * as many as make the correction least.
   */
  class CornerShares
  {
  public:
    /// @param records  of all nodes of the walls.
    CornerShares(const Mesh<2>                 &mesh,
                 const std::vector<Wall<2>>    &walls,
                 const std::vector<WallRecord> &records);

    /**
     * Forces with each wall's own share at the corners. Their sum is that of
     * `forces`, but for a wall that is inclined to the axis and ends on it:
     * there it is the sum along the axis, which has the rest.
     *
     * @param forces  of each record's wall on the material, in N.
     */
    std::vector<Tensor<1, 3>>
    share(const std::vector<Tensor<1, 3>> &forces) const;

    /// See WallCorners.
    const Tensor<1, 2> &
    normal(const unsigned int record) const
    {
      return walls.normals[record];
    }

  private:
    using Run    = WallCorners::Run;
    using Corner = WallCorners::Corner;

    /// A traction near a corner, in Pa.
    struct Share
    {
      unsigned int record;
      Tensor<1, 2> traction;
      double       yielding; ///< its part of a correction, in Pa
    };

    /// How many nodes beside a corner are looked at.
    struct Reach
    {
      unsigned int n_disturbed; ///< continued from others, as the corner is
      unsigned int n_fading;    ///< over which a correction fades
    };

    struct Shares
    {
      std::vector<Share> shares;
      /// Of the tractions at the corner, relative to their size; infinite if
      /// there is no correction that keeps the force.
      double correction;
    };

    /// In N and Pa.
    Tensor<1, 2>
    traction_of(const unsigned int               record,
                const std::vector<Tensor<1, 3>> &forces) const;
    /// At a position in the run: the traction there, or if it is disturbed,
    /// the one that continues those behind.
    Tensor<1, 2>
    expected(const Run                       &run,
             const unsigned int               n_disturbed,
             const unsigned int               position,
             const std::vector<Tensor<1, 3>> &forces) const;
    /// Tractions at the corner's records that are the same for all of them,
    /// seen from each wall, and make up the forces there.
    std::vector<Share>
    equal_shares(const Corner                    &corner,
                 const std::vector<Tensor<1, 3>> &forces) const;
    /// As the walls beside the corner let expect; not yet corrected.
    std::vector<Share>
    expected_shares(const Corner                    &corner,
                    const Reach                      reach,
                    const std::vector<Tensor<1, 3>> &forces) const;
    Shares
    corrected(const Corner                    &corner,
              std::vector<Share>               shares,
              const std::vector<Tensor<1, 3>> &forces) const;
    /// Whether the force is kept without any wall that pulls.
    bool
    all_press(const Shares &found) const;
    std::vector<Share>
    best_shares(const Corner                    &corner,
                const std::vector<Tensor<1, 3>> &forces) const;

    const std::vector<WallRecord> records;
    const WallCorners             walls;
  };
} // namespace Sandglass

#endif
