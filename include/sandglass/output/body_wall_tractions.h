#ifndef sandglass_output_body_wall_tractions_h
#define sandglass_output_body_wall_tractions_h

#include <sandglass/output/body_wall_parts.h>
#include <sandglass/output/reference_pressures.h>
#include <sandglass/output/section_wall_tractions.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// A row of wall_traction.csv in three dimensions: a band of a wall's part.
  struct WallBand
  {
    double      time; ///< in s
    std::string wall, side;
    /// Means over the band's area, in m: along the wall, horizontally from the
    /// middle of the outlet, and above its level.
    double arc_length, distance, height;
    double area; ///< in m^2, as far as the grid goes
    /// Force over area, in Pa: compression, and along the wall upwards or
    /// outwards.
    double normal, tangential;
    /// The largest normal traction of the band's nodes, in Pa, and where.
    double   largest_normal;
    Point<3> largest_at;
    /// In Pa; NaN where formulas say nothing.
    double       janssen_normal;
    WallPressure eurocode_filling, eurocode_discharge;
  };

  /// Columns of wall_traction.csv in three dimensions.
  extern const std::vector<Column<WallBand>> wall_band_table;

  /**
   * Writes wall_traction.csv, whose rows are bands of the walls' parts, and
   * walls.pvd with the tractions at the nodes of the walls' faces.
   */
  template <>
  class WallTractions<3>
  {
  public:
    WallTractions(const OutputParameters   &parameters,
                  const Scene<3>           &scene,
                  const MaterialParameters &material);

    /// Open the files, after deserialization those of the earlier run.
    void
    open();

    /// After deserialization; see CsvFile::refuse_other().
    void
    refuse_other(const std::string &directory) const;

    /**
     * The tractions at t = 0 at all nodes of all walls, sorted by wall and
     * part, on rank 0; empty on the others. Collective.
     *
     * @param records  of the state at rest.
     */
    std::vector<WallTraction>
    at_rest(const WallRecords &records) const;

    /**
     * Likewise the means since `last`, which then is now. Collective.
     *
     * @param time  in s.
     */
    std::vector<WallTraction>
    since(WallImpulses      &last,
          const double       time,
          const WallRecords &records) const;

    /// The same since the last call or, the first time, since the flow's start.
    std::vector<WallTraction>
    since_last(const double time, const WallRecords &records)
    {
      return since(last, time, records);
    }

    /// See WallTractions<2>.
    void
    start_means_anew()
    {
      last = {};
    }

    /// Write what one of these has returned at this time, in s.
    void
    write(const double time, const std::vector<WallTraction> &tractions);

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &table &series &last;
    }

  private:
    /// All ranks' records; sorted, on rank 0.
    std::vector<WallRecord>
    collect(const WallRecords &records) const;
    /// @param force  mean one of the record's wall on the material, in N.
    WallTraction
    make_traction(const double        time,
                  const WallRecord   &record,
                  const Tensor<1, 3> &force) const;
    std::vector<WallBand>
    make_bands(const std::vector<WallTraction> &tractions) const;
    /// The walls' faces with the fields of walls.pvd.
    VtuPiece
    make_picture(const std::vector<WallTraction> &tractions) const;

    const Scene<3>             &scene;
    const bool                  is_writer;
    const ReferencePressures<3> references;
    const BodyWallParts         parts;
    CsvTable<WallBand>          table;
    FieldSeries                 series;

    /// When since_last() was called.
    WallImpulses last;
  };
} // namespace Sandglass

#endif
