# SPDX-License-Identifier: BSD-3-Clause
# Compiles several sources of a module as one (CMake's unity build): most of the time of a first build goes into the
# headers of VTK. For builds of which single sources are not changed: the ParaView plugin and the sanitizers'.
option(MT_UNITY_BUILD "Compile several sources of a module as one" OFF)

# Sources whose names in unnamed namespaces meet those of others.
set(mt_single_sources
  MTCertification:Filters/Certification/vtkMTBallGrid.cxx
  MTCertification:Filters/Certification/vtkMTDirectDeviation.cxx
  MTCertification:Filters/Certification/vtkMTFinerRecord.cxx
  MTCertification:Filters/Certification/vtkMTNormalDeviation.cxx
  MTConstruction:Filters/Construction/vtkMTFinerLevels.cxx
  MTConstruction:Filters/Construction/vtkMTInputMesh.cxx
  MTConstruction:Filters/Construction/vtkMTPointNormals.cxx
  MTConstruction:Filters/Construction/vtkMTSharedIds.cxx
  MTCore:Module/vtkMTPolyDataStream.cxx
  MTIO:IO/MultiTriangulation/vtkMTPositionCodec.cxx
  MTIO:IO/MultiTriangulation/vtkMTTriangleEncoder.cxx
  MTIOCore:IO/Core/vtkMTTextFormat.cxx
  MTIOImage:IO/Image/vtkMTTerrain.cxx
  MTIOImage:IO/Image/vtkMTTerrainStream.cxx
  MTIOMesh:IO/Mesh/Gltf/vtkMTGltfDraco.cxx
  MTIOMesh:IO/Mesh/Gltf/vtkMTGltfMeshopt.cxx
  MTIOMesh:IO/Mesh/Gltf/vtkMTGltfWriter.cxx
  MTIOMesh:IO/Mesh/Obj/vtkMTObjParser.cxx
  MTIOMesh:IO/Mesh/Obj/vtkMTObjStream.cxx
  MTIOMesh:IO/Mesh/Vtk/vtkMTXmlCheck.cxx
  MTIOMesh:IO/Mesh/vtkMTOffReader.cxx
  MTIOMesh:IO/Mesh/vtkMTPlyReader.cxx
  MTIOMesh:IO/Mesh/vtkMTPlyStream.cxx
  MTIOMesh:IO/Mesh/vtkMTStlStream.cxx
  MTRenderingOpenGL2:Rendering/OpenGL2/vtkMTPatchArenaLayout.cxx)

# mt_unity_build(<modules>): where MT_UNITY_BUILD is on; their targets are there by now.
function (mt_unity_build)
  if (NOT MT_UNITY_BUILD)
    return ()
  endif ()
  foreach (module IN LISTS ARGN)
    string(REPLACE "MultiTriangulation::" "" target "${module}")
    if (target STREQUAL "MTVerification") # too many of its names meet
      continue ()
    endif ()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
    # GCC takes the sources of such a build for headers.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    foreach (source IN LISTS mt_single_sources)
      if (source MATCHES "^${target}:(.+)$")
        set_source_files_properties("${MT_SOURCE_DIR}/${CMAKE_MATCH_1}"
          TARGET_DIRECTORY ${target}
          PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      endif ()
    endforeach ()
  endforeach ()
endfunction ()
