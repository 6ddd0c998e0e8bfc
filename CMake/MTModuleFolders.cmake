# SPDX-License-Identifier: BSD-3-Clause
# The folders that are VTK modules, layer by layer: those that have a vtk.module and a CMakeLists.txt, when the modules
# that they name are there, but for MT_OMITTED_FOLDERS. MT_SOURCE_DIR says where; mt_module_files are their vtk.module files, mt_present their names.
set(mt_module_files)
set(mt_present)
set(mt_folders
  Module
  Filters/Sources Filters/Partition Filters/Simplification Filters/Core Filters/Certification Filters/Verification IO/Core
  Rendering/Core
  IO/MultiTriangulation IO/Mesh IO/Image Filters/Construction Rendering/OpenGL2 Filters/General
  Filters/Building Interaction/Viewer)
list(REMOVE_ITEM mt_folders "" ${MT_OMITTED_FOLDERS})
foreach (folder IN LISTS mt_folders)
  if (NOT EXISTS "${MT_SOURCE_DIR}/${folder}/CMakeLists.txt")
    continue ()
  endif ()
  file(STRINGS "${MT_SOURCE_DIR}/${folder}/vtk.module" names REGEX "^ *MultiTriangulation::")
  list(TRANSFORM names STRIP)
  list(POP_FRONT names name)
  list(REMOVE_ITEM names ${mt_present} "")
  if (names)
    message(WARNING "${folder} is left out: no ${names}")
  else ()
    list(APPEND mt_present ${name})
    list(APPEND mt_module_files "${MT_SOURCE_DIR}/${folder}/vtk.module")
  endif ()
endforeach ()
