# SPDX-License-Identifier: BSD-3-Clause
# Language, build type, directories and warnings: what holds for all targets.
if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif ()
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
option(BUILD_SHARED_LIBS "Build shared libraries" ON)
option(BUILD_TESTING "Build the tests" ON)
option(MT_WRAP_PYTHON "Build the Python package" ON)
option(MT_WARNINGS_AS_ERRORS "Stop at the first warning" OFF)

include(GNUInstallDirs)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
if (SKBUILD)
  list(APPEND CMAKE_INSTALL_RPATH "$ORIGIN/../../vtkmodules") # where VTK's own wheel has its libraries
endif ()

# Results must be the same whatever the optimiser may choose: no contraction to fused operations.
add_compile_options(-ffp-contract=off)
# g++ 12.2 drops the rounding of double -> float -> double where it puts neighbouring values into one vector.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
# Functions of a shared library may be inlined within it, as clang does: nothing replaces them from outside.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
add_compile_options(-Wall -Wextra -Wnon-virtual-dtor)
# References and pointers to what is gone are never right, whatever the build: what a compiler sees of them is an error.
include(CheckCXXCompilerFlag)
foreach (warning IN ITEMS dangling dangling-gsl return-stack-address dangling-pointer return-local-addr use-after-free)
  string(MAKE_C_IDENTIFIER "MT_HAS_ERROR_${warning}" has_error)
  check_cxx_compiler_flag(-Werror=${warning} ${has_error})
  if (${has_error})
    add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-Werror=${warning}>)
  endif ()
endforeach ()
if (MT_WARNINGS_AS_ERRORS)
  add_compile_options(-Werror)
endif ()

# VTK's wrapping belongs to one Python: the one that its package was built for, which on Debian is /usr/bin/python3.
# Another python3 may come first on the PATH (pyenv, conda) and must not be taken.
if (NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that VTK was built for")
endif ()

find_program(CCACHE_PROGRAM ccache)
mark_as_advanced(CCACHE_PROGRAM)
if (CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif ()
