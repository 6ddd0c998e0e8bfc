# SPDX-License-Identifier: BSD-3-Clause
# MT_SANITIZE: which sanitizers instrument the toolkit; VTK stays as it is. A list of address, undefined and thread
# (thread alone). ThreadSanitizer needs clang with libomp: with g++ and libgomp its reports are false.
set(MT_SANITIZE "" CACHE STRING "Sanitizers: address, undefined, thread; a list, empty for none")
set_property(CACHE MT_SANITIZE PROPERTY STRINGS "" "address" "undefined" "address;undefined" "thread")

foreach (sanitizer IN LISTS MT_SANITIZE)
  if (NOT sanitizer MATCHES "^(address|undefined|thread)$")
    message(FATAL_ERROR "MT_SANITIZE: '${sanitizer}' is none of address, undefined, thread.")
  endif ()
endforeach ()

option(MT_FUZZ "Build the fuzzers; needs clang" OFF)
if (MT_FUZZ AND NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "MT_FUZZ needs clang: cmake --preset asan.")
endif ()

if (MT_SANITIZE)
  if ("thread" IN_LIST MT_SANITIZE)
    if (NOT MT_SANITIZE STREQUAL "thread")
      message(FATAL_ERROR "MT_SANITIZE: thread goes with no other sanitizer.")
    endif ()
    if (NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
      message(FATAL_ERROR "MT_SANITIZE=thread needs clang and libomp: cmake --preset tsan.")
    endif ()
  endif ()
  list(JOIN MT_SANITIZE "," sanitizers)
  add_compile_options(-fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${sanitizers})
  if (MT_WRAP_PYTHON)
    message(STATUS "MT_SANITIZE: no Python package, because the interpreter is not instrumented.")
    set(MT_WRAP_PYTHON OFF)
  endif ()
endif ()
