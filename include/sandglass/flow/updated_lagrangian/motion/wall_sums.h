#ifndef sandglass_flow_updated_lagrangian_motion_wall_sums_h
#define sandglass_flow_updated_lagrangian_motion_wall_sums_h

#include <sandglass/flow/flow_view.h>
#include <sandglass/scene/scene.h>

#include <vector>

namespace Sandglass
{
  /**
   * What walls have done to the material since the start, at the vertices of
   * the scene's mesh: nodes that slide give their forces to the ends of the
   * scene's edge on which they are, as linear functions on it would.
   */
  class WallSums
  {
  public:
    explicit WallSums(const Scene<2> &scene);

    /**
     * Add what a wall does at a place on it.
     *
     * @param impulse  on the material, in N s (plane strain: per metre).
     */
    void
    add(const WallId        wall,
        const Point<2>     &position,
        const Tensor<1, 2> &impulse);

    const std::vector<WallRecord> &
    records() const
    {
      return sums;
    }

    void
    clear();

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &sums;
    }

  private:
    struct Edge
    {
      WallId                      wall;
      std::array<Point<2>, 2>     ends;
      std::array<unsigned int, 2> records; ///< of the ends
    };

    std::vector<Edge>       edges;
    std::vector<WallRecord> sums;
  };
} // namespace Sandglass

#endif
