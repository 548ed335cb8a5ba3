#ifndef sandglass_element_test_element_test_results_h
#define sandglass_element_test_element_test_results_h

#include <sandglass/base/table.h>
#include <sandglass/element_test/element_test_row.h>
#include <sandglass/output/summary_file.h>

#include <string>
#include <vector>

namespace Sandglass
{
  /// Columns of element_test.csv.
  extern const std::vector<Column<ElementTestRow>> element_test_table;

  /// What an element test has come to so far.
  struct ElementTestResults
  {
    std::string status = Status::running;
    std::string message; ///< of the error; empty if there was none
    std::string law;
    std::string kind;
    bool        is_shear = false;

    unsigned long  n_rows = 0;
    ElementTestRow last;
    ElementTestRow at_peak;                     ///< where q is largest
    double         largest_friction_angle = 0.; ///< in degrees

    void
    add(const ElementTestRow &row);

    /// The strain of a row that the test drives.
    double
    driven_strain(const ElementTestRow &row) const
    {
      return is_shear ? row.shear_strain : row.axial_strain;
    }
  };

  /// Keys of an element test's summary.json.
  extern const std::vector<Column<ElementTestResults>>
    element_test_summary_table;

  /// For the screen.
  std::string
  to_text(const ElementTestResults &results);
} // namespace Sandglass

#endif
