# SPDX-License-Identifier: BSD-3-Clause
# Compiles several sources of a module as one (CMake's unity build): most of the time of a first build goes into the
# headers of VTK. For builds of which single sources are not changed: the release preset, which ./quickstart and
# ./runtests build, the ParaView plugin and the sanitizers'. The preset "dev" compiles each source by itself.
option(MT_UNITY_BUILD "Compile several sources of a module as one" OFF)

# Sources whose names in unnamed namespaces meet those of others.
set(mt_single_sources
  MTCertification:Filters/Certification/vtkMTCellsOver.cxx
  MTCertification:Filters/Certification/vtkMTDirectDeviation.cxx
  MTCertification:Filters/Certification/vtkMTDirectImprover.cxx
  MTCertification:Filters/Certification/vtkMTFinerRecord.cxx
  MTCertification:Filters/Certification/vtkMTNormalDeviation.cxx
  MTConstruction:Filters/Construction/Input/vtkMTInputSpoolSorted.cxx
  MTConstruction:Filters/Construction/vtkMTBarycentreSpool.cxx
  MTConstruction:Filters/Construction/vtkMTBorderOrder.cxx
  MTConstruction:Filters/Construction/vtkMTFinerLevels.cxx
  MTConstruction:Filters/Construction/vtkMTInputFragment.cxx
  MTConstruction:Filters/Construction/vtkMTInputMesh.cxx
  MTConstruction:Filters/Construction/vtkMTPointNormals.cxx
  MTConstruction:Filters/Construction/vtkMTSharedIds.cxx
  MTCore:Module/vtkMTHalfedgePairs.cxx
  MTCore:Module/vtkMTPolyDataStream.cxx
  MTCore:Module/vtkMTRecordSort.cxx
  MTIO:IO/MultiTriangulation/vtkMTNormalCodec.cxx
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
  MTRenderingCore:Rendering/Core/vtkMTCutIds.cxx
  MTRenderingCore:Rendering/Core/vtkMTFinestNear.cxx
  MTRenderingCore:Rendering/Core/vtkMTFinestPatches.cxx
  MTRenderingCore:Rendering/Core/vtkMTInputIdFinder.cxx
  MTRenderingOpenGL2:Rendering/OpenGL2/vtkMTPatchArenaLayout.cxx
  MTRenderingOpenGL2:Rendering/OpenGL2/vtkMTSelectionIds.cxx
  MTVerification:Filters/Verification/Readers/vtkMTVerifyGltfInput.cxx
  MTVerification:Filters/Verification/Readers/vtkMTVerifyObjInput.cxx
  MTVerification:Filters/Verification/Readers/vtkMTVerifyStlInput.cxx
  MTVerification:Filters/Verification/Readers/vtkMTVerifyVtkInput.cxx
  MTVerification:Filters/Verification/Sampling/vtkMTValueSampling.cxx
  MTVerification:Filters/Verification/Search/vtkMTLatticeKeys.cxx
  MTVerification:Filters/Verification/vtkMTInputArrays.cxx
  MTVerification:Filters/Verification/vtkMTVerifyTerrainDem.cxx
  MTVerification:Filters/Verification/vtkMTVerifyTerrainGrid.cxx
  MTVerification:Filters/Verification/vtkMTVerifyTerrainTiff.cxx
  MTVerification:Filters/Verification/vtkMTVerifyVolumeMetaImage.cxx)

# mt_unity_build(<modules>): where MT_UNITY_BUILD is on; their targets are there by now.
function (mt_unity_build)
  if (NOT MT_UNITY_BUILD)
    return ()
  endif ()
  foreach (module IN LISTS ARGN)
    string(REPLACE "MultiTriangulation::" "" target "${module}")
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

# Tests of one program whose names in unnamed namespaces meet those of others.
set(mt_single_tests
  Certification/TestCellsOver.cxx
  Certification/TestTriangleDeviation.cxx
  Construction/TestFarOutliers.cxx
  Construction/TestInputIds.cxx
  Construction/TestOutOfCore.cxx
  Construction/TestPointWelding.cxx
  General/TestInputIdFinder.cxx
  IO/TestFile.cxx
  IO/TestGolden.cxx
  IOMesh/TestMeshReader.cxx
  IOMesh/TestObjReader.cxx
  Rendering/TestMapperPlacement.cxx
  Rendering/TestMapperPrecision.cxx
  RenderingCore/TestPatchLoader.cxx
  RenderingCore/TestTargetCutView.cxx
  Simplification/TestModes.cxx
  Simplification/TestQuadrics.cxx
  Simplification/TestRegions.cxx
  Verification/TestVerifyVolumeInput.cxx)

# mt_unity_build_test(<target>): the same for a program of tests, whose sources lie in the current folder.
function (mt_unity_build_test target)
  if (NOT MT_UNITY_BUILD)
    return ()
  endif ()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  foreach (source IN LISTS mt_single_tests)
    if (source MATCHES "^${folder}/(.+)$")
      set_source_files_properties("${CMAKE_MATCH_1}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif ()
  endforeach ()
endfunction ()
