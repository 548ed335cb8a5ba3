#ifndef sandglass_report_residence_map_h
#define sandglass_report_residence_map_h

#include <filesystem>
#include <string>

namespace Sandglass
{
  namespace Report
  {
    /**
     * The raster of residence.vtu as JSON: `width` and `height` of its cells in
     * m, and for each cell its middle `x`, `y`, the `time` in s when its
     * material left (null where none has), and the `share` that has. Throws
     * InputError where the file is damaged.
     */
    std::string
    residence_map(const std::filesystem::path &file);
  } // namespace Report
} // namespace Sandglass

#endif
