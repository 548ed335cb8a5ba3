#ifndef sandglass_output_gauges_h
#define sandglass_output_gauges_h

#include <sandglass/base/table.h>
#include <sandglass/flow/flow_view.h>
#include <sandglass/output/csv_file.h>
#include <sandglass/output/eurocode_pressures.h>
#include <sandglass/output/output_parameters.h>
#include <sandglass/scene/scene.h>

#include <array>
#include <string>
#include <vector>

namespace Sandglass
{
  /// Sums over the particles around a gauge.
  struct GaugeSums
  {
    double                mass = 0., volume = 0.; ///< in kg and m^3
    Tensor<1, 3>          momentum;               ///< in kg m/s
    std::array<double, 6> stress_volume{};        ///< in Pa m^3
  };

  /// A row of gauges.csv.
  struct GaugeRow
  {
    double       time = 0.; ///< in s
    std::string  name;
    Point<3>     point;    ///< in m
    WallPressure traction; ///< NaN where the gauge is not on a wall
    GaugeSums    around;
  };

  /// Columns of gauges.csv.
  extern const std::vector<Column<GaugeRow>> gauge_table;

  /**
   * Time series at points: the state of the material around them and, on walls,
   * tractions. The material around a point is that no farther from it than the
   * root (in space the cubic root) of the measure of the mesh's cell there.
   */
  template <int dim>
  class Gauges
  {
  public:
    /// Throws InputError where a point has not as many coordinates as the
    /// scene, or is outside of the mesh.
    Gauges(const OutputParameters &parameters, const Scene<dim> &scene);

    bool
    is_on() const
    {
      return !gauges.empty();
    }

    /// Whether a gauge is on a wall.
    bool
    needs_tractions() const
    {
      return is_any_on_wall;
    }

    /// Consider a particle of this rank.
    void
    add(const ParticleRecord &particle);

    /// All particles have been added. Collective.
    void
    end_pass();

    /**
     * Write a row for each gauge, of what the last pass has found. On rank 0.
     *
     * @param time         in s.
     * @param traction_at  of a wall at a point.
     */
    template <typename TractionAt>
    void
    write(const double time, const TractionAt &traction_at)
    {
      if (!is_on())
        return;
      for (const Gauge &gauge : gauges)
        table.add_row({time,
                       gauge.name,
                       gauge.point,
                       traction_at(gauge.point),
                       gauge.around});
      table.flush();
    }

    /// On rank 0.
    void
    open();
    /// After deserialization; see CsvFile::refuse_other().
    void
    refuse_other(const std::string &directory) const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &table;
    }

  private:
    struct Gauge
    {
      std::string name;
      Point<3>    point;
      double      reach;   ///< in m
      GaugeSums   of_rank; ///< in this pass
      GaugeSums   around;  ///< of all ranks, in the last pass
    };

    const MPI_Comm     communicator;
    std::vector<Gauge> gauges;
    bool               is_any_on_wall = false;
    CsvTable<GaugeRow> table;
  };
} // namespace Sandglass

#endif
