#ifndef sandglass_output_wall_envelope_h
#define sandglass_output_wall_envelope_h

#include <sandglass/output/csv_file.h>
#include <sandglass/output/section_wall_tractions.h>

#include <boost/serialization/vector.hpp>

#include <string>
#include <vector>

namespace Sandglass
{
  /// Columns of wall_envelope.csv: of the latest traction at each node, with
  /// its range so far.
  extern const std::vector<Column<WallTraction>> wall_envelope_table;

  /**
   * The largest and smallest normal tractions of a run at each node of each
   * wall, beside those at rest. On rank 0, where the tractions are.
   */
  class WallEnvelope
  {
  public:
    /// Of the initial mass: with less of it in the silo, a pressure does not
    /// count as smallest, since walls run empty then.
    static constexpr double full_share = 0.75;

    /**
     * Consider the tractions of one time, always the same nodes in the same
     * order, and give each its range. Those at t = 0 are at rest.
     *
     * @param mass_share  in the silo, of the initial one.
     */
    void
    add(std::vector<WallTraction> &tractions, const double mass_share);

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &ranges;
    }

  private:
    std::vector<NormalRange> ranges;
  };

  /// The text of wall_envelope.csv. An outlet that opens has no row.
  std::string
  wall_envelope_text(const std::vector<WallTraction> &tractions,
                     const bool                       outlet_opens);
} // namespace Sandglass

#endif
