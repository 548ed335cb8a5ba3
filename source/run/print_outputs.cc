#include <sandglass/choices/all_laws.h>
#include <sandglass/element_test/element_test_results.h>
#include <sandglass/flow/updated_lagrangian/static_stage.h>
#include <sandglass/output/body_wall_tractions.h>
#include <sandglass/output/design_results.h>
#include <sandglass/output/grid_fields.h>
#include <sandglass/output/history.h>
#include <sandglass/output/particle_fields.h>
#include <sandglass/output/section_wall_tractions.h>
#include <sandglass/output/summary.h>
#include <sandglass/run/markdown.h>
#include <sandglass/run/print_outputs.h>
#include <sandglass/study/convergence_results.h>
#include <sandglass/study/smallest_outlet.h>

namespace Sandglass
{
  namespace
  {
    std::string
    code(const char *text)
    {
      return text == nullptr || *text == '\0' ? "" :
                                                '`' + std::string(text) + '`';
    }



    std::string
    file(const std::string &name, const std::string &what)
    {
      return "\n## " + name + "\n\n" + what + "\n\n";
    }



    template <typename Source>
    std::string
    field_rows(const std::vector<Field<Source>> &fields,
               const std::string                &where = "")
    {
      std::string text;
      for (const Field<Source> &field : fields)
        text += markdown_row({code(field.name),
                              field.unit,
                              std::to_string(n_components(field)),
                              where + field.meaning});
      return text;
    }



    template <typename... Laws>
    std::string
    law_rows(TypeList<Laws...>)
    {
      std::string text;
      const auto  add_law = [&text](const auto law) {
        using Law = typename decltype(law)::Type;
        for (const StateVariable &variable : Law::state_variables)
          text += markdown_row({code(variable.name),
                                variable.unit,
                                std::to_string(variable.n_components),
                                "with the law " + std::string(Law::name)});
      };
      (add_law(TypeTag<Laws>()), ...);
      return text;
    }



    template <typename Source>
    std::string
    columns(const std::string &kind, const std::vector<Column<Source>> &table)
    {
      std::string text = markdown_head({kind, "Unit", "Meaning"});
      for (const Column<Source> &column : table)
        text += markdown_row({code(column.name), column.unit, column.meaning});
      return text;
    }



    std::string
    walls()
    {
      std::string text = markdown_head({"Column of wall_traction.csv",
                                        "Field of walls.pvd",
                                        "Unit",
                                        "Meaning"});
      for (const WallQuantity &quantity : wall_table)
        text += markdown_row({code(quantity.column),
                              code(quantity.field),
                              quantity.unit,
                              quantity.meaning});
      return text;
    }



    const std::vector<std::string> field_head = {"Field",
                                                 "Unit",
                                                 "Components",
                                                 "Meaning"};

    const std::string introduction =
      "# Output files\n\n"
      "Written by `sandglass --print-outputs`. Masses, energies and rates are "
      "those of the whole silo, also where only half of it is computed; in "
      "plane strain they are per metre of depth. Symmetric tensors have "
      "ParaView's order of components: XX, YY, ZZ, XY, YZ, XZ.\n";
  } // namespace



  std::string
  print_outputs()
  {
    return introduction +
           file("particles.pvd",
                "The particles as dots, every `Output/Interval`.") +
           markdown_head(field_head) + field_rows(particle_table) +
           law_rows(AllLaws()) +
           file("grid.pvd",
                "The computational mesh, every `Output/Interval`.") +
           markdown_head(field_head) + field_rows(grid_node_table, "node: ") +
           field_rows(grid_cell_table, "cell: ") +
           file("walls.pvd and wall_traction.csv",
                "The walls as lines between their nodes, and the same as a "
                "table, every `Output/Interval`.") +
           walls() +
           file("wall_envelope.csv",
                "A row for each node of each wall: the largest and smallest "
                "pressures of the run so far, beside those at rest and those "
                "of EN 1991-4. Written anew every `Output/Interval`.") +
           columns("Column", wall_envelope_table) +
           file("wall_traction.csv in three dimensions",
                "A row for each band of a wall, as high as a cell (on floors a "
                "ring around the outlet), every `Output/Interval`; walls.pvd "
                "then has the fields above at the nodes of the walls' faces.") +
           columns("Column", wall_band_table) +
           file("static.vtu",
                "The state at rest in the filled part of the mesh; beside the "
                "cells' means below, `displacement` (m) at the nodes.") +
           columns("Field", static_cell_table) +
           file("history.csv", "A row every `Output/History interval`.") +
           columns("Column", history_table) +
           file("flow_rate.csv",
                "A row every `Output/History interval`, where material can "
                "leave.") +
           columns("Column", flow_rate_table) +
           file("flow_profile.csv",
                "Where material can leave: how fast it sinks beside the walls "
                "and in the middle, while the middle half of the mass that has "
                "been discharged so far flowed. Written anew every "
                "`Output/Interval`.") +
           columns("Column", flow_profile_table) +
           file("residence.csv",
                "With `Output/Residence`, every `Output/Interval`: a row for "
                "each of the 16 layers of the initial height.") +
           columns("Column", residence_table) +
           file("residence.vtu",
                "With `Output/Residence`: a raster of the initial material, "
                "with the times when it left. Written anew every "
                "`Output/Interval`; what leaves between two rows of "
                "`history.csv` counts as leaving in the middle of that time.") +
           markdown_head(field_head) + field_rows(residence_cell_table) +
           file("gauges.csv",
                "With `Output/Gauges`, every `Output/History interval`: a row "
                "for each gauge.") +
           columns("Column", gauge_table) +
           file("summary.json",
                "The run so far, with every file of fields, and as a whole in "
                "the end.") +
           columns("Key", summary_table) +
           file("study.csv of --study convergence",
                "A row for each run; `study.svg` shows the same.") +
           columns("Column", convergence_table) +
           file("summary.json of --study convergence",
                "The study so far, after each run; the runs have their own.") +
           columns("Key", convergence_summary_table) +
           file("study.csv of --study smallest-outlet",
                "A row for each run, in the order of the runs.") +
           columns("Column", smallest_outlet_table) +
           file("summary.json of --study smallest-outlet",
                "The study so far, after each run; the runs have their own.") +
           columns("Key", smallest_outlet_summary_table) +
           file("element_test.csv of --element-test",
                "The start, and a row for each step. Strains are shares of the "
                "initial lengths and volume, not logarithms; in compression "
                "strains and stresses are positive.") +
           columns("Column", element_test_table) +
           file("summary.json of --element-test",
                "The test, also where it could not go on.") +
           columns("Key", element_test_summary_table);
  }
} // namespace Sandglass
