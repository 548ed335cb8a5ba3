#ifndef sandglass_report_packing_h
#define sandglass_report_packing_h

#include <cstdint>
#include <string>
#include <vector>

namespace Sandglass
{
  namespace Report
  {
    /**
     * `bytes` as text that a browser unpacks by itself: compressed in zlib's
     * format ("deflate" to its DecompressionStream), then in base 64.
     */
    std::string
    pack(const std::vector<std::uint8_t> &bytes);

    /// The same of a text.
    std::string
    pack(const std::string &text);

    /// `text` as HTML shows it.
    std::string
    escaped(const std::string &text);
  } // namespace Report
} // namespace Sandglass

#endif
