#ifndef sandglass_output_wall_tractions_h
#define sandglass_output_wall_tractions_h

#include <sandglass/material/material_parameters.h>
#include <sandglass/output/csv_file.h>
#include <sandglass/output/eurocode_pressures.h>
#include <sandglass/output/field_series.h>
#include <sandglass/output/janssen.h>
#include <sandglass/output/output_parameters.h>
#include <sandglass/output/silo_measures.h>
#include <sandglass/output/wall_lines.h>
#include <sandglass/walls/wall_force.h>
#include <sandglass/walls/wall_parameters.h>

namespace Sandglass
{
  /// Force over area at one node of a wall.
  struct WallTraction
  {
    WallForce        force;
    WallLines::Place place;
    double           normal;         ///< in Pa, compression positive
    double           tangential;     ///< in Pa, positive: pushes material up
    double           janssen_normal; ///< in Pa; NaN where Janssen says nothing
    WallPressure     eurocode_filling, eurocode_discharge;
  };

  /// Writes wall_traction.csv, and walls.pvd with the same values on lines.
  class WallTractions
  {
  public:
    WallTractions(const OutputParameters   &parameters,
                  const Scene              &scene,
                  const MaterialParameters &material,
                  const WallParameters     &walls);

    /// Open the files, after deserialization those of the earlier run.
    void
    open();

    /**
     * The tractions at all nodes of all walls, sorted by wall and along it, on
     * rank 0; empty on the others. Collective.
     *
     * @param forces  at this rank's nodes.
     */
    std::vector<WallTraction>
    collect(const std::vector<WallForce> &forces) const;

    /// Write what collect() returned.
    void
    write(const double time, const std::vector<WallTraction> &tractions);

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &table &series;
    }

  private:
    double
    janssen_pressure(const WallForce &force) const;
    WallPressure
    eurocode_pressure(const EurocodePressures::Load load,
                      const WallForce              &force) const;

    const MPI_Comm          communicator;
    const bool              is_writer;
    const double            fill_top;
    const SiloMeasures      measures;
    const Janssen           janssen;
    const EurocodePressures eurocode;
    const WallLines         lines;
    CsvFile                 table;
    FieldSeries             series;
  };

  /// The walls as lines between their nodes.
  VtuPiece
  wall_fields(const std::vector<WallTraction> &tractions);
} // namespace Sandglass

#endif
