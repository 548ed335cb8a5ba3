# What Sandglass needs, each with a text that says what is missing and which
# Debian package holds it.

# Stop unless `found` is true.
function(sandglass_require found what package)
  if(NOT ${found})
    message(FATAL_ERROR
      "\nSandglass needs ${what}, and it was not found.\n"
      "On Debian or Ubuntu: apt-get install ${package}\n")
  endif()
endfunction()

# deal.II's features, by the names of its configuration.
set(missing_features "")
foreach(feature WITH_MPI WITH_P4EST WITH_TRILINOS WITH_GMSH GMSH_WITH_API)
  if(NOT DEAL_II_${feature})
    string(APPEND missing_features "  DEAL_II_${feature}\n")
  endif()
endforeach()
if(missing_features)
  message(FATAL_ERROR
    "\nThe deal.II in ${DEAL_II_PATH} was built without features that Sandglass needs:\n"
    "${missing_features}"
    "Use a deal.II that has them (Debian's libdeal.ii-dev does), or configure"
    " deal.II again with them set to ON.\n")
endif()

find_package(Eigen3 3.3 QUIET NO_MODULE)
sandglass_require(Eigen3_FOUND "Eigen 3.3 or later" libeigen3-dev)

find_package(Boost 1.71 QUIET COMPONENTS program_options)
sandglass_require(Boost_FOUND "Boost.Program_options" libboost-program-options-dev)
find_package(Boost 1.71 QUIET COMPONENTS program_options serialization)
sandglass_require(Boost_FOUND "Boost.Serialization" libboost-serialization-dev)

if(SANDGLASS_BUILD_FIGURES)
  # Before VTK is looked for again below, so that VTK_LIBRARIES, with which
  # sandglass is linked, doesn't hold these.
  find_package(VTK 9 QUIET COMPONENTS
    ImagingCore IOImage IOXML IOXMLParser RenderingCore RenderingFreeType)
  sandglass_require(VTK_FOUND
    "VTK 9 with the modules ImagingCore, IOImage, IOXML, IOXMLParser, RenderingCore and RenderingFreeType (or -DSANDGLASS_BUILD_FIGURES=OFF)"
    libvtk9-dev)
endif()
# Charts and what is below them draw the plots of studies, into SVG files.
find_package(VTK 9 QUIET COMPONENTS CommonCore CommonDataModel IOXML
  ChartsCore IOExport RenderingContext2D RenderingFreeType RenderingOpenGL2)
sandglass_require(VTK_FOUND
  "VTK 9 with the modules CommonCore, CommonDataModel, IOXML, ChartsCore, IOExport, RenderingContext2D, RenderingFreeType and RenderingOpenGL2"
  libvtk9-dev)

# Draws the charts of reports, which hold it.
find_file(D3_JAVASCRIPT d3.min.js PATHS
  /usr/share/nodejs/d3/dist NO_DEFAULT_PATH)
mark_as_advanced(D3_JAVASCRIPT)
sandglass_require(D3_JAVASCRIPT
  "the JavaScript library D3, version 5 or later (or -DD3_JAVASCRIPT=/path/to/d3.min.js)" node-d3)

# Gmsh's C++ API comes without a CMake package on Debian.
find_path(GMSH_INCLUDE_DIR gmsh.h)
find_library(GMSH_LIBRARY gmsh)
mark_as_advanced(GMSH_INCLUDE_DIR GMSH_LIBRARY)
sandglass_require(GMSH_INCLUDE_DIR "the header gmsh.h of Gmsh's C++ API" libgmsh-dev)
sandglass_require(GMSH_LIBRARY "the library of Gmsh's C++ API" libgmsh-dev)
add_library(sandglass_gmsh INTERFACE)
target_include_directories(sandglass_gmsh SYSTEM INTERFACE ${GMSH_INCLUDE_DIR})
target_link_libraries(sandglass_gmsh INTERFACE ${GMSH_LIBRARY})

if(SANDGLASS_BUILD_TESTS OR SANDGLASS_BUILD_BENCHMARKS)
  find_package(GTest QUIET)
  sandglass_require(GTest_FOUND
    "GoogleTest (or -DSANDGLASS_BUILD_TESTS=OFF)" libgtest-dev)
endif()

if(SANDGLASS_BUILD_TESTS)
  # Without numdiff the regression tests would run but compare nothing.
  find_program(NUMDIFF numdiff)
  mark_as_advanced(NUMDIFF)
  sandglass_require(NUMDIFF
    "numdiff (or -DSANDGLASS_BUILD_TESTS=OFF)" numdiff)
  find_program(VALGRIND valgrind)
  mark_as_advanced(VALGRIND)
  sandglass_require(VALGRIND
    "valgrind (or -DSANDGLASS_BUILD_TESTS=OFF)" valgrind)
endif()

if(SANDGLASS_BUILD_BENCHMARKS)
  find_package(benchmark QUIET)
  sandglass_require(benchmark_FOUND
    "Google Benchmark (or -DSANDGLASS_BUILD_BENCHMARKS=OFF)" libbenchmark-dev)
  find_path(VALGRIND_INCLUDE_DIR valgrind/callgrind.h)
  mark_as_advanced(VALGRIND_INCLUDE_DIR)
  sandglass_require(VALGRIND_INCLUDE_DIR
    "valgrind's headers (or -DSANDGLASS_BUILD_BENCHMARKS=OFF)" valgrind)
endif()
