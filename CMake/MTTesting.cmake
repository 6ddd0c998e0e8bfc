# SPDX-License-Identifier: BSD-3-Clause
# One function for each kind of test.
find_package(GTest REQUIRED)
include(GoogleTest)

# Programs that open a render window run under Xvfb, always: pictures must not depend on the display of whoever tests.
set(MT_WITH_DISPLAY "${CMAKE_SOURCE_DIR}/CMake/with-display")

# What tests write goes here.
set(MT_TEST_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/Testing/Temporary")
file(MAKE_DIRECTORY "${MT_TEST_OUTPUT_DIRECTORY}")

# Builds the unit tests of these layers, which need no render window: what the sanitizer presets build and run.
add_custom_target(mt_unit_tests)
set(MT_LAYERS_WITHOUT_WINDOW
  Module Sources Partition Simplification FiltersCore Certification Verification Construction IOCore IO IOMesh IOImage
  Building RenderingCore General Stiff)
# These open windows or run the command. AddressSanitizer looks at some of their tests (CMakePresets.json), without
# leaks: OpenGL, the X server's libraries and GDAL keep what they have got.
set(MT_LAYERS_WITH_FOREIGN_LEAKS Rendering ApplicationsRender)
# Those of the layers that have threads, for ThreadSanitizer.
add_custom_target(mt_thread_tests)
set(MT_LAYERS_WITH_THREADS Partition Simplification FiltersCore Construction IO RenderingCore)

# Sanitizers leave these out: what they run, smaller tests run as well, and instrumented they took four tenths of a
# stage's time. In the release build all tests run.
set(MT_LEFT_OUT_BY_SANITIZERS)
if (MT_SANITIZE)
  list(APPEND MT_LEFT_OUT_BY_SANITIZERS
    Assembler.AMillionWedgesOfOnePointAreFoundOneByOne
    BackgroundBuild.EndsAtAnyTimeAndLeavesNothing
    Builder.CertifiedErrorHoldsAndIsTight
    Builder.CutOfClosedMeshHasNoBorder
    Builder.EveryModelIsValidInEveryCut
    Builder.EveryPlaceOfAPatchIsWithinItsError
    Builder.EveryUsableTriangleIsStored
    Builder.RootHasAtMostTwoPatches
    Builder.SameBytesForAnyNumberOfThreads
    CutFollower.CutTakesLittleTimeAlongAFlight
    ExactPoints.FinestLevelGivesTheInputsBitsBack
    ExtractionBudget.IsUsedToNineTenthsFromFiftyMeanPatchesOn
    FileBuilder.BytesDoNotDependOnThreadsMemoryOrFolder
    Holes.SmallHolesDoNotStandInTheWayOfTheTarget
    Kinds/ColorsOfTheData*
    Mapper.ArrayChangesShowInTheNextFrame
    Mapper.UnevenCutsHaveNoCracks
    MapperBudget*
    MapperLoading*
    MapperPasses*
    MapperRate.MemoryOfAFrameStaysForTheNextOne
    MapperSharing.CullingInStereoChangesNoPixel
    MeshReader.CutFilesOfVtksFormatsAreNeverTakenForWhole
    MeshReader.RealMeshes*
    MeshStream.VtpOfEveryEncoding*
    Modes.FastIsNearlyAsNearToTheFloorAsBest
    OutOfCore.ModelDoesNotDependOnMemoryOrThreads
    OutOfCore.RegionThatIsTooLargeForTheLimitSaysHowMuchIsMissing
    PartitionRealMeshes*
    Pipeline.*
    Pitfalls.TheTargetIsMetInTriangles
    Placement.MirroredActorsAreLitAndCulledAsVtkDoesIt
    Places/MapperAt*
    Regions.SimplifiedApartTheyMakeAClosedManifoldAtEveryLevel
    Render.ASmallerPixelErrorDrawsMoreAndABudgetIsKept
    Render.CamerasAndColoursDoWhatTheySay
    Seams.ATextureAroundACylinderStaysContinuousInEveryTriangle
    Sizes/MapperUnderScale*
    States/AgainstPolyDataMapper*
    Verifier.AMeshOfAnotherShapeIsFoundByTheCheckForIt
    View.APreviewOfAMeshIsSeenBeforeItsModel
    View.ControlCEndsABuildAndLeavesNothing
    */PartitionStrategy.NoRegionExceedsFourTimesTheTarget*)
  list(JOIN MT_LEFT_OUT_BY_SANITIZERS ":" MT_LEFT_OUT_BY_SANITIZERS)
  set(MT_LEFT_OUT_BY_SANITIZERS TEST_FILTER "-${MT_LEFT_OUT_BY_SANITIZERS}")
endif ()

# mt_add_unit_test(<layer> [DISPLAY] SOURCES <files> LINK <targets>)
# One GoogleTest program test_<layer>; its tests are labelled <layer>. DISPLAY: it opens render windows and runs under
# Xvfb. The program sees MT_SOURCE_DIRECTORY and MT_TEST_OUTPUT_DIRECTORY as string literals, and the helpers of
# Testing/Common: mt_testing, and mt_testing_io where it links MTIO.
function (mt_add_unit_test layer)
  cmake_parse_arguments(PARSE_ARGV 1 arg "DISPLAY" "" "SOURCES;LINK")
  if (arg_UNPARSED_ARGUMENTS OR NOT arg_SOURCES)
    message(FATAL_ERROR "mt_add_unit_test(${layer}): SOURCES missing or unknown arguments '${arg_UNPARSED_ARGUMENTS}'")
  endif ()
  foreach (module IN LISTS arg_LINK)
    if (module MATCHES "^MultiTriangulation::" AND NOT TARGET ${module})
      message(WARNING "The tests of ${layer} are left out: no ${module}")
      return ()
    endif ()
  endforeach ()
  set(target test_${layer})
  add_executable(${target} ${arg_SOURCES})
  mt_unity_build_test(${target})
  # What takes time is in the libraries; optimised fully the tests would take a third longer to compile.
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  set(helpers mt_testing)
  if ("MultiTriangulation::MTIO" IN_LIST arg_LINK)
    list(PREPEND helpers mt_testing_io)
  endif ()
  target_link_libraries(${target} PRIVATE ${arg_LINK} ${helpers} GTest::gtest GTest::gtest_main)
  target_compile_definitions(${target} PRIVATE
    "MT_SOURCE_DIRECTORY=\"${CMAKE_SOURCE_DIR}\""
    "MT_TEST_OUTPUT_DIRECTORY=\"${MT_TEST_OUTPUT_DIRECTORY}\"")
  set(modules ${arg_LINK})
  list(FILTER modules INCLUDE REGEX "^(VTK|MultiTriangulation)::")
  if (modules)
    vtk_module_autoinit(TARGETS ${target} MODULES ${modules})
  endif ()
  if (arg_DISPLAY)
    # gtest_discover_tests starts the program through this, when it asks for its tests and when it runs them.
    set_property(TARGET ${target} PROPERTY CROSSCOMPILING_EMULATOR "${MT_WITH_DISPLAY}")
  endif ()
  if (layer IN_LIST MT_LAYERS_WITHOUT_WINDOW OR layer IN_LIST MT_LAYERS_WITH_FOREIGN_LEAKS)
    add_dependencies(mt_unit_tests ${target})
  endif ()
  set(environment)
  if ("address" IN_LIST MT_SANITIZE AND layer IN_LIST MT_LAYERS_WITH_FOREIGN_LEAKS)
    set(environment ENVIRONMENT "ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1:detect_leaks=0")
  endif ()
  if (layer IN_LIST MT_LAYERS_WITH_THREADS)
    add_dependencies(mt_thread_tests ${target})
  endif ()
  gtest_discover_tests(${target}
    DISCOVERY_MODE PRE_TEST
    ${MT_LEFT_OUT_BY_SANITIZERS}
    PROPERTIES LABELS ${layer} TIMEOUT 900 ${environment})
endfunction ()

# mt_add_script_test(<name> LABEL <label> COMMAND <command...>)
# A test that is a script: the command succeeds or fails.
function (mt_add_script_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "DISPLAY" "LABEL" "COMMAND")
  if (arg_UNPARSED_ARGUMENTS OR NOT arg_COMMAND OR NOT arg_LABEL)
    message(FATAL_ERROR "mt_add_script_test(${name}): LABEL or COMMAND missing, or unknown '${arg_UNPARSED_ARGUMENTS}'")
  endif ()
  if (arg_DISPLAY)
    list(PREPEND arg_COMMAND "${MT_WITH_DISPLAY}")
  endif ()
  add_test(NAME ${name} COMMAND ${arg_COMMAND})
  # Scripts run for long: they begin before the unit tests, so that none runs alone at the end.
  set_tests_properties(${name} PROPERTIES LABELS ${arg_LABEL} TIMEOUT 900 COST 100)
endfunction ()
