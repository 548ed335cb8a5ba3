# How each of our targets is compiled.

# ccache, where it is installed. The sloppiness and the flag -fpch-preprocess
# below are what ccache asks for with GCC's precompiled headers.
find_program(CCACHE ccache)
mark_as_advanced(CCACHE)
if(CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

# deal.II's headers that many of our files include. To parse them takes about
# 10 s; precompiled, 1.5 s. A source file still includes what it uses: with
# SANDGLASS_PCH=OFF the compiler checks that it does.
set(precompiled_headers
  <deal.II/base/mpi.h>
  <deal.II/base/parameter_acceptor.h>
  <deal.II/base/point.h>
  <deal.II/base/quadrature_lib.h>
  <deal.II/base/symmetric_tensor.h>
  <deal.II/distributed/shared_tria.h>
  <deal.II/dofs/dof_handler.h>
  <deal.II/dofs/dof_tools.h>
  <deal.II/fe/fe_values.h>
  <deal.II/grid/tria.h>
  <deal.II/lac/affine_constraints.h>
  <deal.II/lac/la_parallel_vector.h>
  <deal.II/particles/particle_handler.h>)

# sandglass_compile_together(<target> EXCEPT <file>...)
#
# The compiler takes longer over the headers that a file includes than over the
# file, and several files share them. With SANDGLASS_UNITY=OFF each is compiled
# by itself, which shows what includes it lacks.
function(sandglass_compile_together target)
  cmake_parse_arguments(files "" "" "EXCEPT" ${ARGN})
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ${SANDGLASS_UNITY}
    UNITY_BUILD_BATCH_SIZE 6
    UNITY_BUILD_CODE_AFTER_INCLUDE "#undef INSTANTIATE")
  set_source_files_properties(${files_EXCEPT} PROPERTIES
    SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# sandglass_setup_target(<target> [QUICKLY <other target>])
#
# Compile `target` as deal.II and we want it, with the precompiled headers of the
# library. QUICKLY: with little optimization, and with the headers that `other
# target`, compiled like this, has precompiled; its own if it is `target`.
function(sandglass_setup_target target)
  cmake_parse_arguments(setup "" "QUICKLY" "" ${ARGN})
  deal_ii_setup_target(${target})

  # These come after deal.II's own flags, and the last of two wins. -g1 keeps
  # function names and lines for backtraces and profilers, and compiles in
  # three quarters of the time of -g.
  target_compile_options(${target} PRIVATE -Wall -Wextra)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    set(optimization -O3)
    if(setup_QUICKLY)
      set(optimization -O1 -fno-unroll-loops -fno-unroll-all-loops)
    endif()
    target_compile_options(${target} PRIVATE
      ${optimization} -fno-math-errno -fno-trapping-math -g1)
  endif()
  if(SANDGLASS_SANITIZE)
    # vptr needs type information that deal.II's library keeps to itself. -O1
    # because the checks are slow enough, -g1 for the lines in the report. With
    # sanitizers GCC 12 takes parts of Boost and the standard library for
    # uninitialised.
    set(sanitizers -fsanitize=address,undefined -fno-sanitize=vptr)
    target_compile_options(${target} PRIVATE
      ${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer -O1 -g1
      -Wno-maybe-uninitialized)
    target_link_options(${target} PRIVATE ${sanitizers})
  endif()
  if(SANDGLASS_NATIVE)
    target_compile_options(${target} PRIVATE -march=native)
  endif()

  if(SANDGLASS_PCH)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${target} PRIVATE -fpch-preprocess)
    endif()
    set(owner sandglass_library)
    if(setup_QUICKLY)
      set(owner ${setup_QUICKLY})
      list(APPEND precompiled_headers <gtest/gtest.h>)
    endif()
    if(target STREQUAL owner)
      target_precompile_headers(${target} PRIVATE ${precompiled_headers})
    else()
      target_precompile_headers(${target} REUSE_FROM ${owner})
    endif()
  endif()
endfunction()
