#ifndef sandglass_output_design_results_h
#define sandglass_output_design_results_h

#include <sandglass/output/flow_profile.h>
#include <sandglass/output/gauges.h>
#include <sandglass/output/residence.h>
#include <sandglass/output/summary.h>
#include <sandglass/output/wall_envelope.h>

#include <functional>
#include <string>
#include <vector>

namespace Sandglass
{
  /// What someone who designs a silo asks of a run beside fields: the walls'
  /// envelope, the kind of flow, residence, and gauges.
  template <int dim>
  class DesignResults
  {
  public:
    DesignResults(const OutputParameters &parameters, const Scene<dim> &scene);

    /// Whether end_row() needs the walls' tractions since the row before.
    bool
    needs_tractions() const
    {
      return gauges.needs_tractions();
    }

    /// Whether there is anything to add().
    bool
    looks_at_particles() const
    {
      return profile.is_on() || residence.is_on() || gauges.is_on();
    }

    /// Consider a particle of this rank, once for each row of history.csv.
    void
    add(const ParticleRecord &particle)
    {
      profile.add(particle);
      residence.add(particle);
      gauges.add(particle);
    }

    /// All particles have been added, for this time in s. Collective.
    void
    end_row(const double time)
    {
      profile.end_pass(communicator);
      residence.end_pass(time);
      gauges.end_pass();
    }

    /**
     * Write what has been added, on rank 0.
     *
     * @param tractions  since the row before, or at rest.
     */
    void
    write_row(const double time, const std::vector<WallTraction> &tractions);

    /// Consider the walls' tractions since the last output, or those at rest,
    /// and give them their range so far.
    void
    add_walls(std::vector<WallTraction> &tractions, const double mass_share)
    {
      envelope.add(tractions, mass_share);
    }

    /**
     * An output of fields is due: what is left is to write the files, beside
     * the run and on rank 0.
     *
     * @param tractions        as add_walls() has left them; empty: none.
     * @param discharged_mass  so far, in kg.
     */
    std::function<void()>
    output(const double                     time,
           const double                     discharged_mass,
           const std::vector<WallTraction> &tractions);

    /// What summary.json says of it; on rank 0.
    void
    summarise(Summary &summary) const;

    /// Open the files, after deserialization those of the earlier run. On rank
    /// 0.
    void
    open();
    /// After deserialization; see CsvFile::refuse_other().
    void
    refuse_other(const std::string &directory) const;

    /// What walls had done with the last row; for tractions since.
    WallImpulses wall_sums;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &wall_sums &envelope &profile &residence &gauges;
    }

  private:
    const std::string directory;
    const MPI_Comm    communicator;
    const bool        has_open_outlet;

    WallEnvelope envelope;
    FlowProfile  profile;
    Residence    residence;
    Gauges<dim>  gauges;
  };
} // namespace Sandglass

#endif
