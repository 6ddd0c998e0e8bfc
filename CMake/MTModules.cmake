# SPDX-License-Identifier: BSD-3-Clause
# Finds VTK and builds the toolkit's VTK modules, layer by layer.
set(MT_SOURCE_DIR "${CMAKE_SOURCE_DIR}")
include(MTModuleFolders)
include(MTUnityBuild)

# VTK's components: what the vtk.module files name, and what the command, the examples, the tests and Python add. What
# is linked must be named here or there, or CMake complains of targets that were not found (MPI::MPI_C).
set(mt_vtk_components
  CommonColor CommonSystem FiltersCore FiltersGeneral FiltersSources IOImage InteractionStyle RenderingAnnotation
  RenderingFreeType RenderingLOD RenderingUI TestingCore TestingRendering)
if (MT_WRAP_PYTHON)
  list(APPEND mt_vtk_components Python WrappingPythonCore)
endif ()
foreach (file IN LISTS mt_module_files)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  file(STRINGS "${file}" lines REGEX "^ *VTK::")
  foreach (line IN LISTS lines)
    string(REGEX REPLACE "^ *VTK::([A-Za-z0-9]+).*$" "\\1" component "${line}")
    list(APPEND mt_vtk_components "${component}")
  endforeach ()
endforeach ()
list(REMOVE_DUPLICATES mt_vtk_components)
list(SORT mt_vtk_components)
find_package(VTK 9.1 REQUIRED COMPONENTS ${mt_vtk_components})

# A wheel takes one component of all modules, and holds no symbolic links, so the libraries have no versions there.
if (SKBUILD)
  set(mt_component_for_each_module OFF)
else ()
  set(mt_component_for_each_module ON)
endif ()
set(MT_CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/multitriangulation")
vtk_module_scan(
  MODULE_FILES ${mt_module_files}
  PROVIDES_MODULES mt_modules
  WANT_BY_DEFAULT ON
  ENABLE_TESTS OFF)
vtk_module_build(
  MODULES ${mt_modules}
  PACKAGE MultiTriangulation
  INSTALL_EXPORT MultiTriangulation
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/multitriangulation"
  CMAKE_DESTINATION "${MT_CMAKE_DESTINATION}"
  TARGET_SPECIFIC_COMPONENTS ${mt_component_for_each_module}
  USE_EXTERNAL OFF)

# vtk_module_build has an argument for this, but takes a SOVERSION whose major number is 0 for none. Until 1.0 every minor
# version may break the binary interface, so it is part of the name that programs load.
if (PROJECT_VERSION_MAJOR EQUAL 0)
  set(MT_SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
else ()
  set(MT_SOVERSION "${PROJECT_VERSION_MAJOR}")
endif ()
foreach (module IN LISTS mt_modules)
  if (SKBUILD)
    continue ()
  endif ()
  vtk_module_set_properties(${module} VERSION "${PROJECT_VERSION}" SOVERSION "${MT_SOVERSION}")
endforeach ()

mt_unity_build(${mt_modules})

# What reads bytes from outside counts its branches for the fuzzers. Nothing else does: it would slow down the unit tests,
# which are built in the same tree.
if (MT_FUZZ)
  foreach (module IN ITEMS MTCore MTIOCore MTIO MTIOMesh)
    vtk_module_compile_options(MultiTriangulation::${module} PRIVATE -fsanitize=fuzzer-no-link)
  endforeach ()
endif ()
