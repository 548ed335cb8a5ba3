#include <sandglass/element_test/element_test_results.h>

#include <iomanip>
#include <sstream>

namespace Sandglass
{
  const std::vector<Column<ElementTestRow>> element_test_table = {
    {"axial_strain",
     "1",
     [](const ElementTestRow &row) { return row.axial_strain; },
     "shortening over the initial height, compression positive, as all below"},
    {"volumetric_strain",
     "1",
     [](const ElementTestRow &row) { return row.volumetric_strain; },
     "share of the initial volume that is lost"},
    {"shear_strain",
     "1",
     [](const ElementTestRow &row) { return row.shear_strain; },
     "displacement of the top over the initial height, in simple shear"},
    {"axial_stress_Pa",
     "Pa",
     [](const ElementTestRow &row) { return row.axial_stress; },
     "Cauchy stress"},
    {"lateral_stress_Pa",
     "Pa",
     [](const ElementTestRow &row) { return row.lateral_stress; },
     "in the plane of the shear strain"},
    {"out_of_plane_stress_Pa",
     "Pa",
     [](const ElementTestRow &row) { return row.out_of_plane_stress; },
     "normal to that plane"},
    {"shear_stress_Pa",
     "Pa",
     [](const ElementTestRow &row) { return row.shear_stress; },
     "positive where it resists a positive shear strain"},
    {"void_ratio",
     "1",
     [](const ElementTestRow &row) { return row.void_ratio; },
     "of laws that have one; `nan` with the others"}};



  const std::vector<Column<ElementTestResults>> element_test_summary_table = {
    {"status",
     "",
     [](const ElementTestResults &r) { return r.status; },
     "`running`, which a test that was killed stays; `finished`, or `failed` "
     "with an error"},
    {"message",
     "",
     [](const ElementTestResults &r) { return r.message; },
     "of the error that ended the test",
     [](const ElementTestResults &r) { return !r.message.empty(); }},
    {"law",
     "",
     [](const ElementTestResults &r) { return r.law; },
     "`Material/Model`"},
    {"kind",
     "",
     [](const ElementTestResults &r) { return r.kind; },
     "`Element test/Kind`"},
    {"rows",
     "1",
     [](const ElementTestResults &r) { return r.n_rows; },
     "of `element_test.csv`"},
    {"peak_von_mises_stress_Pa",
     "Pa",
     [](const ElementTestResults &r) { return r.at_peak.von_mises_stress(); },
     "the largest q = √(3/2 s : s); in triaxial tests the difference of axial "
     "and lateral stress"},
    {"strain_at_peak",
     "1",
     [](const ElementTestResults &r) { return r.driven_strain(r.at_peak); },
     "axial strain where q is largest, in simple shear the shear strain"},
    {"peak_friction_angle_degrees",
     "degrees",
     [](const ElementTestResults &r) { return r.largest_friction_angle; },
     "the largest mobilised angle asin((σ₁ − σ₃) / (σ₁ + σ₃)), cohesion "
     "included"},
    {"final_friction_angle_degrees",
     "degrees",
     [](const ElementTestResults &r) {
       return r.last.mobilised_friction_angle();
     },
     "that angle in the last row; `null` without stress"},
    {"final_strain",
     "1",
     [](const ElementTestResults &r) { return r.driven_strain(r.last); },
     "as `strain_at_peak`"},
    {"final_volumetric_strain",
     "1",
     [](const ElementTestResults &r) { return r.last.volumetric_strain; },
     "likewise, compression positive"},
    {"final_axial_stress_Pa",
     "Pa",
     [](const ElementTestResults &r) { return r.last.axial_stress; },
     "likewise"},
    {"final_lateral_stress_ratio",
     "1",
     [](const ElementTestResults &r) {
       return r.last.lateral_stress / r.last.axial_stress;
     },
     "lateral over axial stress"},
    {"final_void_ratio",
     "1",
     [](const ElementTestResults &r) { return r.last.void_ratio; },
     "`null` with laws that have none"}};



  void
  ElementTestResults::add(const ElementTestRow &row)
  {
    // On a plateau the first row counts, whatever the rounding of the others.
    constexpr double growth = 1. + 1e-6;
    if (n_rows == 0 ||
        row.von_mises_stress() > growth * at_peak.von_mises_stress())
      at_peak = row;
    // Without stress it is no number, and never the largest.
    const double angle = row.mobilised_friction_angle();
    if (angle > largest_friction_angle)
      largest_friction_angle = angle;
    last = row;
    ++n_rows;
  }



  std::string
  to_text(const ElementTestResults &results)
  {
    const char *const strain =
      results.is_shear ? "shear strain " : "axial strain ";
    std::ostringstream text;
    text << std::setprecision(4) << "  largest q "
         << results.at_peak.von_mises_stress() << " Pa at " << strain
         << results.driven_strain(results.at_peak)
         << "; largest mobilised friction angle "
         << results.largest_friction_angle << " degrees\n"
         << "  in the end: " << strain << results.driven_strain(results.last)
         << ", volumetric strain " << results.last.volumetric_strain
         << "; stress axial " << results.last.axial_stress << ", lateral "
         << results.last.lateral_stress << ", out of plane "
         << results.last.out_of_plane_stress << ", shear "
         << results.last.shear_stress << " Pa; friction angle "
         << results.last.mobilised_friction_angle() << " degrees\n";
    if (!std::isnan(results.last.void_ratio))
      text << "  void ratio " << results.last.void_ratio << '\n';
    return text.str();
  }
} // namespace Sandglass
