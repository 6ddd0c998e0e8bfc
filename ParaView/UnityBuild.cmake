# SPDX-License-Identifier: BSD-3-Clause
# The plugin compiles several sources of a module as one (CMake's unity build): most of the time of a first build goes
# into VTK's headers, and there is no other build of this project that would want single objects. Sources whose names
# in unnamed namespaces meet those of others are left out.
function (mt_leave_out_of_unity)
  foreach (source IN ITEMS
      MTConstruction:Filters/Construction/vtkMTInputMesh.cxx
      MTCore:Module/vtkMTPolyDataStream.cxx
      MTIO:IO/MultiTriangulation/vtkMTPositionCodec.cxx
      MTIO:IO/MultiTriangulation/vtkMTTriangleEncoder.cxx
      MTIOCore:IO/Core/vtkMTTextFormat.cxx
      MTIOImage:IO/Image/vtkMTTerrain.cxx
      MTIOImage:IO/Image/vtkMTTerrainStream.cxx
      MTIOMesh:IO/Mesh/Gltf/vtkMTGltfDraco.cxx
      MTIOMesh:IO/Mesh/Gltf/vtkMTGltfMeshopt.cxx
      MTIOMesh:IO/Mesh/Obj/vtkMTObjParser.cxx
      MTIOMesh:IO/Mesh/Obj/vtkMTObjStream.cxx
      MTIOMesh:IO/Mesh/vtkMTPlyReader.cxx
      MTIOMesh:IO/Mesh/vtkMTStlStream.cxx
      MTRenderingOpenGL2:Rendering/OpenGL2/vtkMTPatchArenaLayout.cxx)
    string(REGEX MATCH "^([^:]+):(.+)$" matched "${source}")
    if (TARGET ${CMAKE_MATCH_1})
      set_source_files_properties("${MT_SOURCE_DIR}/${CMAKE_MATCH_2}"
        TARGET_DIRECTORY ${CMAKE_MATCH_1}
        PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif ()
  endforeach ()
endfunction ()
cmake_language(DEFER CALL mt_leave_out_of_unity)
