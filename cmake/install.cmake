# cmake --install, and a Debian package by cpack in the build directory.

install(TARGETS sandglass RUNTIME DESTINATION bin)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/prm DESTINATION share/sandglass)
install(FILES README.md LICENSE DESTINATION share/doc/sandglass)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/doc/ DESTINATION share/doc/sandglass/doc
  FILES_MATCHING PATTERN *.md PATTERN *.png PATTERN *.bib)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME sandglass)
set(CPACK_PACKAGE_CONTACT "The Sandglass developers <sandglass@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# The libraries that the programs load, by dpkg-shlibdeps of dpkg-dev; mpirun is
# called by the user only, but a run on several ranks needs it.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS openmpi-bin)
include(CPack)
