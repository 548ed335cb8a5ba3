#ifndef sandglass_output_section_wall_tractions_h
#define sandglass_output_section_wall_tractions_h

#include <sandglass/base/table.h>
#include <sandglass/flow/flow_view.h>
#include <sandglass/material/material_parameters.h>
#include <sandglass/output/csv_file.h>
#include <sandglass/output/field_series.h>
#include <sandglass/output/normal_range.h>
#include <sandglass/output/output_parameters.h>
#include <sandglass/output/reference_pressures.h>
#include <sandglass/output/section_wall_lines.h>
#include <sandglass/output/silo_measures.h>

#include <boost/serialization/vector.hpp>

#include <string_view>
#include <vector>

namespace Sandglass
{
  /// Force over area at one node of a section's wall, a mean over some time.
  struct WallTraction
  {
    double           time;   ///< when the mean ends, in s
    WallRecord       record; ///< the node's
    BoundaryRole     role;
    std::string_view wall_name;
    WallLines::Place place;
    Tensor<1, 3>     on_material; ///< of the wall, in Pa

    double janssen_normal; ///< in Pa; NaN where Janssen says nothing
    /// Likewise.
    WallPressure eurocode_filling, eurocode_discharge;
    /// What its patch loads add, likewise.
    double eurocode_filling_patch, eurocode_discharge_patch;

    /// What the wall has borne here so far.
    NormalRange range;

    /// In Pa, compression positive.
    double
    normal() const
    {
      return -(on_material * record.normal);
    }

    /// In Pa, along the wall's tangent that points up, or along +x where the
    /// wall is horizontal: positive where the wall pushes material up.
    double
    tangential() const;
  };

  /// A quantity as a column of wall_traction.csv and as a field of walls.pvd.
  struct WallQuantity
  {
    const char *column; ///< null: not in wall_traction.csv
    const char *field;  ///< null: not in walls.pvd
    const char *unit;   ///< SI; "1" for pure numbers, "" for texts
    std::variant<double (*)(const WallTraction &),
                 std::string (*)(const WallTraction &),
                 Tensor<1, 3> (*)(const WallTraction &)>
                value;
    const char *meaning;
  };

  extern const std::vector<WallQuantity> wall_table;

  /// Columns of wall_traction.csv.
  std::vector<Column<WallTraction>>
  wall_columns();

  /// Add the nodes of the walls, with the fields of walls.pvd.
  void
  add_wall_points(VtuPiece &piece, const std::vector<WallTraction> &tractions);

  /// The walls as lines between their nodes, with the fields of walls.pvd.
  VtuPiece
  wall_fields(const std::vector<WallTraction> &tractions);

  /// What walls had done up to a time, in the order of the tractions; on rank
  /// 0.
  struct WallImpulses
  {
    double                    time = 0.; ///< in s
    std::vector<Tensor<1, 3>> impulses;  ///< in N s

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &time &impulses;
    }
  };

  template <int dim>
  class WallTractions;

  /// Writes wall_traction.csv, and walls.pvd with the same values on lines.
  template <>
  class WallTractions<2>
  {
  public:
    WallTractions(const OutputParameters   &parameters,
                  const Scene<2>           &scene,
                  const MaterialParameters &material);

    /// Open the files, after deserialization those of the earlier run.
    void
    open();

    /// After deserialization; see CsvFile::refuse_other().
    void
    refuse_other(const std::string &directory) const;

    /**
     * The tractions at t = 0 at all nodes of all walls, sorted by wall and
     * along it, on rank 0; empty on the others. Collective.
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

    /// The next means begin where the flow's sums are zero: they have begun
    /// anew.
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
    /// A record, and where it lies on its wall.
    struct PlacedRecord
    {
      WallRecord       record;
      WallLines::Place place;
    };

    /// All ranks' records; sorted, on rank 0.
    std::vector<PlacedRecord>
    collect(const WallRecords &records) const;
    /// Where a wall has a bend, a node has two records: let that of the face on
    /// which the line comes to it be the first.
    static void
    order_at_bends(std::vector<PlacedRecord> &sorted);
    /// @param forces  mean ones of the records' walls on the material, in N.
    std::vector<WallTraction>
    make_tractions(const double                     time,
                   const std::vector<PlacedRecord> &placed,
                   const std::vector<Tensor<1, 3>> &forces) const;
    WallTraction
    make_traction(const double        time,
                  const PlacedRecord &placed,
                  const Tensor<1, 3> &force) const;

    const Scene<2>             &scene;
    const bool                  is_writer;
    const ReferencePressures<2> references;
    const WallLines             lines;
    CsvTable<WallTraction>      table;
    FieldSeries                 series;

    /// When since_last() was called.
    WallImpulses last;
  };
} // namespace Sandglass

#endif
