# SPDX-License-Identifier: BSD-3-Clause
# The plugin's Debian package: cpack -G DEB, with CPACK_DEBIAN_PACKAGE_DEPENDS as Packaging/make_debs finds it. It brings its own
# libraries, those that build among them, so it is under the GPL.
install(FILES "${MT_SOURCE_DIR}/LICENSE" "${MT_SOURCE_DIR}/Packaging/third-party-notices.md"
  DESTINATION share/doc/paraview-multitriangulation COMPONENT runtime)
set(CPACK_PACKAGE_NAME paraview-multitriangulation)
set(CPACK_PACKAGE_VENDOR "The Multi-Triangulation toolkit authors")
set(CPACK_PACKAGE_CONTACT "The Multi-Triangulation toolkit authors <noreply@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL runtime)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
include(CPack)
