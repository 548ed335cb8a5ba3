# The program sandglass-report, which needs no deal.II and nothing of the library,
# and beside it the templates that its pages are made of.

file(GLOB report_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/source/report/*.cc)
add_executable(sandglass-report ${report_sources})
target_include_directories(sandglass-report PRIVATE ${PROJECT_SOURCE_DIR}/include)
target_compile_options(sandglass-report PRIVATE -O2 -Wall -Wextra)
# Boost 1.74 warns of what its own JSON parser does.
target_compile_definitions(sandglass-report PRIVATE BOOST_BIND_GLOBAL_PLACEHOLDERS)
target_link_libraries(sandglass-report PRIVATE
  Boost::program_options VTK::CommonCore VTK::CommonDataModel VTK::IOCore VTK::IOXML)

# The program looks for them in share below its own directory, as here, or below
# the one above, as where it is installed.
set(template_directory share/sandglass/report)
file(GLOB report_templates CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/source/report/template/*)
list(APPEND report_templates ${D3_JAVASCRIPT})
set(report_copies "")
foreach(template ${report_templates})
  get_filename_component(name ${template} NAME)
  set(copy ${PROJECT_BINARY_DIR}/${template_directory}/${name})
  add_custom_command(OUTPUT ${copy}
    COMMAND ${CMAKE_COMMAND} -E copy ${template} ${copy}
    DEPENDS ${template}
    VERBATIM)
  list(APPEND report_copies ${copy})
endforeach()
add_custom_target(report_templates DEPENDS ${report_copies})
add_dependencies(sandglass-report report_templates)

install(TARGETS sandglass-report RUNTIME DESTINATION bin COMPONENT report)
install(FILES ${report_templates} DESTINATION ${template_directory} COMPONENT report)
