# SPDX-License-Identifier: BSD-3-Clause
# What find_package(MultiTriangulation) reads, in the build tree and in the install tree.
include(CMakePackageConfigHelpers)

vtk_module_export_find_packages(
  CMAKE_DESTINATION "${MT_CMAKE_DESTINATION}"
  FILE_NAME MultiTriangulation-vtk-module-find-packages.cmake
  MODULES ${mt_modules})

# The VTK components that the modules themselves need; a consumer may ask VTK for more.
set(mt_exported_vtk_components)
foreach (module IN LISTS mt_modules)
  foreach (kind IN ITEMS depends private_depends)
    get_property(depends GLOBAL PROPERTY "_vtk_module_${module}_${kind}")
    list(FILTER depends INCLUDE REGEX "^VTK::")
    list(APPEND mt_exported_vtk_components ${depends})
  endforeach ()
endforeach ()
list(REMOVE_DUPLICATES mt_exported_vtk_components)
list(TRANSFORM mt_exported_vtk_components REPLACE "^VTK::" "")
list(SORT mt_exported_vtk_components)
list(JOIN mt_exported_vtk_components " " mt_exported_vtk_components)

set(config_directory "${CMAKE_BINARY_DIR}/${MT_CMAKE_DESTINATION}")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/MultiTriangulationConfig.cmake.in"
  "${config_directory}/MultiTriangulationConfig.cmake"
  INSTALL_DESTINATION "${MT_CMAKE_DESTINATION}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${config_directory}/MultiTriangulationConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${config_directory}/MultiTriangulationConfig.cmake"
    "${config_directory}/MultiTriangulationConfigVersion.cmake"
  DESTINATION "${MT_CMAKE_DESTINATION}"
  COMPONENT development)

