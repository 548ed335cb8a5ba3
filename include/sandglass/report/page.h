#ifndef sandglass_report_page_h
#define sandglass_report_page_h

#include <sandglass/report/run_directory.h>

#include <string>

namespace Sandglass
{
  namespace Report
  {
    /**
     * The report of a run as one page of HTML that loads nothing: the
     * templates of source/report/template, D3, and what the run has written,
     * which the page's scripts unpack and draw.
     *
     * Throws InputError where a file of the run is damaged, and
     * std::runtime_error where the templates are not found.
     */
    std::string
    make_page(const RunDirectory &run);
  } // namespace Report
} // namespace Sandglass

#endif
