#ifndef sandglass_study_silo_study_h
#define sandglass_study_silo_study_h

#include <deal.II/base/mpi.h>

#include <sandglass/output/csv_file.h>
#include <sandglass/output/json_object.h>
#include <sandglass/output/output_directory.h>
#include <sandglass/output/summary_file.h>
#include <sandglass/run/parameter_file.h>
#include <sandglass/run/run.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /**
   * Several runs of one silo, each in a directory of its own below that in
   * which their results together are written, after each of them.
   */
  class SiloStudy
  {
  public:
    virtual ~SiloStudy() = default;

    /**
     * Make all runs. Collective. Throws InputError before anything is written,
     * RunError that names the run which has failed, RunStopped when a signal
     * has stopped one; results before it are kept.
     */
    void
    perform();

  protected:
    /// Read the input; nothing is written yet. Throws InputError for scenes
    /// that have no flow rate, or of which the program can't make variants.
    /// @param name  on the command line.
    /// @param subdirectories  how the names of the runs' directories begin.
    SiloStudy(Parameters          &parameters,
              const CommandLine   &command_line,
              const ParameterFile &file,
              const MPI_Comm       communicator,
              const std::string   &name,
              const std::string   &subdirectories);

    /// Make the runs, and call write_results() after each.
    virtual void
    make_runs() = 0;

    /// Whether a run has come to its end.
    virtual bool
    has_results() const = 0;

    /// The run under way, as messages begin with it.
    virtual std::string
    run_in_words() const = 0;

    /// What the study has found, for the screen.
    virtual std::string
    conclusion() const = 0;

    /// Write results so far. On one rank.
    /// @param status,message  see summary.json.
    virtual void
    write(const std::string &status, const std::string &message) = 0;

    /// One run of the parameters as they are; only progress on the screen.
    /// @param which  the end of its directory's name.
    RunResult
    run_in(const std::string &which, const std::vector<std::string> &warnings);

    /// The directory of such a run, below the study's.
    std::string
    subdirectory(const std::string &which) const
    {
      return subdirectories + which;
    }

    /// Results so far. Collective.
    void
    write_results();

    /// What is known on rank 0, on every rank. Collective.
    template <typename Numbers>
    Numbers
    shared(const Numbers &numbers) const
    {
      if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
        return numbers;
      return dealii::Utilities::MPI::broadcast(communicator, numbers);
    }

    Parameters          &parameters;
    const CommandLine   &command_line;
    const ParameterFile &file;
    const MPI_Comm       communicator;
    OutputDirectory      output;
    const std::string   &directory;
    Log                  log;

  private:
    /// The first run's input is accepted: nothing of an older study is left.
    void
    begin();

    void
    write_results(const std::string &status, const std::string &message);

    /// Keep the results before the run that has just ended before its time.
    /// Collective.
    /// @return that run, and the message.
    std::string
    keep_results(const std::string &status, const std::string &what);

    [[noreturn]] void
    fail(const std::string &what);

    const std::string subdirectories;
    bool              has_begun = false;
  };

  /// Write a study's study.csv and summary.json. On one rank. Throws RunError
  /// where they can't be written.
  template <typename Row, typename Results>
  void
  write_study(const std::string                  &directory,
              const std::vector<Column<Row>>     &columns,
              const std::vector<Row>             &rows,
              const std::vector<Column<Results>> &keys,
              const Results                      &results)
  {
    CsvTable<Row> table(directory + "/study.csv", columns, Row());
    table.open();
    for (const Row &row : rows)
      table.add_row(row);
    table.flush();

    JsonObject json;
    json.add(keys, results);
    write_summary_file(directory, json.text());
  }

  /// A number with three digits, as in names of directories.
  std::string
  short_text(const double value);
} // namespace Sandglass

#endif
