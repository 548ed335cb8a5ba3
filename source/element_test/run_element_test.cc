#include <deal.II/base/mpi.h>

#include <sandglass/base/exceptions.h>
#include <sandglass/choices/choose_law.h>
#include <sandglass/element_test/element_test.h>
#include <sandglass/element_test/element_test_results.h>
#include <sandglass/element_test/run_element_test.h>
#include <sandglass/output/banner.h>
#include <sandglass/output/csv_file.h>
#include <sandglass/output/json_object.h>
#include <sandglass/output/output_directory.h>
#include <sandglass/output/summary_file.h>

namespace Sandglass
{
  using namespace dealii;

  namespace
  {
    /// As the parameter file has it.
    std::string
    kind_in_words()
    {
      auto &prm = ParameterAcceptor::prm;
      prm.enter_subsection("Element test");
      const std::string kind = prm.get("Kind");
      prm.leave_subsection();
      return kind;
    }



    void
    write_summary(const ElementTestResults &results,
                  const std::string        &directory)
    {
      JsonObject json;
      json.add(element_test_summary_table, results);
      write_summary_file(directory, json.text());
    }



    /// The rows, and what they come to. On one rank. Throws RunError.
    template <typename Law>
    void
    run_and_write(const ElementTest<Law> &test,
                  const std::string      &directory,
                  ElementTestResults     &results)
    {
      CsvTable<ElementTestRow> table(directory + "/element_test.csv",
                                     element_test_table,
                                     ElementTestRow());
      write_summary(results, directory);
      table.open();
      try
        {
          test.run([&](const ElementTestRow &row) {
            table.add_row(row);
            results.add(row);
          });
          results.status = Status::finished;
        }
      catch (const std::exception &error)
        {
          results.status  = Status::failed;
          results.message = message_of(error);
        }
      table.flush();
      write_summary(results, directory);
      if (results.status == Status::failed)
        throw RunError(results.message);
    }
  } // namespace



  void
  run_element_test(const Parameters               &parameters,
                   const std::vector<std::string> &warnings,
                   const MPI_Comm                  communicator,
                   Log                            &log)
  {
    OutputDirectory    directory(parameters.output.directory, communicator);
    ElementTestResults results;
    results.law      = parameters.material.model;
    results.kind     = kind_in_words();
    results.is_shear = parameters.element_test.is_shear();
    choose_law(parameters.material, [&](const auto tag) {
      using Law                          = typename decltype(tag)::Type;
      const MaterialConstants &constants = parameters.material;
      const Law                law(constants);
      const ElementTest<Law>   test(law,
                                  constants,
                                  parameters.element_test,
                                  parameters.particle_stage.stress_integration);
      log.stream() << banner(communicator) << std::flush;
      log.warn(warnings);
      log.stream() << "Element test: " << results.kind << ", law "
                   << results.law << std::endl;
      directory.start(log);
      directory.write_parameters();
      try
        {
          do_and_share_errors(communicator, [&]() {
            if (Utilities::MPI::this_mpi_process(communicator) == 0)
              run_and_write(test, directory.path, results);
          });
        }
      catch (const RunError &error)
        {
          log.record_error(error.what());
          throw;
        }
    });
    log.stream() << to_text(results) << "Results are in " << directory.path
                 << std::endl;
  }
} // namespace Sandglass
