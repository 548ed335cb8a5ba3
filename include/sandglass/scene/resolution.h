#ifndef sandglass_scene_resolution_h
#define sandglass_scene_resolution_h

#include <limits>
#include <string>

namespace Sandglass
{
  /// How fine a silo is computed.
  struct Resolution
  {
    /// Edge length of the cells, in m; NaN where a mesh file has its own.
    double element_size = std::numeric_limits<double>::quiet_NaN();
    /// The same at the outlet's lip; 0: as elsewhere.
    double       outlet_element_size = 0.;
    unsigned int particles_per_cell  = 0;

    /// Whether cells are smaller at the outlet's lip than elsewhere.
    bool
    is_graded() const
    {
      return outlet_element_size > 0. && outlet_element_size < element_size;
    }

    /// The shortest edges, in m.
    double
    smallest_size() const
    {
      return is_graded() ? outlet_element_size : element_size;
    }
  };

  /// For the log, as `0.1 m large, 0.01 m at the outlet's lip, 9 particles in
  /// each`.
  std::string
  to_text(const Resolution &resolution);
} // namespace Sandglass

#endif
