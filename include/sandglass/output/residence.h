#ifndef sandglass_output_residence_h
#define sandglass_output_residence_h

#include <sandglass/base/table.h>
#include <sandglass/flow/flow_view.h>
#include <sandglass/output/csv_file.h>
#include <sandglass/output/output_parameters.h>
#include <sandglass/output/residence_raster.h>
#include <sandglass/output/residence_summary.h>

#include <boost/serialization/vector.hpp>

#include <vector>

namespace Sandglass
{
  /// A row of residence.csv: what a layer of the initial material has lost
  /// since the row before, and still has.
  struct ResidenceRow
  {
    double        time; ///< in s
    unsigned long layer;
    double        mass_left, mass_remaining; ///< in kg
  };

  /// Columns of residence.csv.
  extern const std::vector<Column<ResidenceRow>> residence_table;

  /// A cell of the raster, for residence.vtu.
  struct ResidenceCell
  {
    double initial_mass = 0.; ///< in kg
    double mass         = 0.; ///< still in the silo, in kg
    /// Of the mass that has left, times the time when it left, and its square.
    double mass_time = 0., mass_time_square = 0.;

    double
    mass_left() const
    {
      return initial_mass - mass;
    }

    /// In s; NaN where nothing has left.
    double
    mean_time() const
    {
      return mass_time / mass_left();
    }

    /// Standard deviation, in s.
    double
    spread() const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &initial_mass &mass &mass_time &mass_time_square;
    }
  };

  /// Fields of residence.vtu.
  extern const std::vector<Field<ResidenceCell>> residence_cell_table;

  /**
   * When material has left the silo (has sunk below the outlet level), by its
   * first place: a map over a raster of the initial material, and each layer's
   * loss over time.
   *
   * It compares what is left of each raster cell's mass from one row of
   * history.csv to the next, so that nothing is kept with the particles, halves
   * of particles count as their parents do, and no mass is counted twice or
   * never. What leaves between two rows leaves in the middle of that time.
   */
  class Residence
  {
  public:
    template <int dim>
    Residence(const OutputParameters &parameters, const Scene<dim> &scene);

    bool
    is_on() const
    {
      return is_asked;
    }

    /// Consider a particle of this rank.
    void
    add(const ParticleRecord &particle);

    /// All particles have been added, for this time in s. Collective.
    void
    end_pass(const double time);

    /// The rows of residence.csv that are due at this time, in s.
    std::vector<ResidenceRow>
    rows(const double time);

    /// On rank 0.
    void
    open();
    void
    write(const std::vector<ResidenceRow> &rows);
    /// After deserialization; see CsvFile::refuse_other().
    void
    refuse_other(const std::string &directory) const;

    /// The map.
    VtuPiece
    map() const;

    ResidenceSummary
    summary() const;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &is_started &last_time &cells &written &table;
    }

  private:
    const bool            is_asked;
    const MPI_Comm        communicator;
    const double          symmetry_factor;
    const ResidenceRaster raster;

    /// Mass of this rank's particles by raster cell in this pass, in kg.
    std::vector<double> masses;

    bool                       is_started = false;
    double                     last_time  = 0.; ///< of a pass, in s
    std::vector<ResidenceCell> cells;
    /// What each layer had when it was last written, in kg.
    std::vector<double> written;

    CsvTable<ResidenceRow> table;
  };
} // namespace Sandglass

#endif
