# SPDX-License-Identifier: BSD-3-Clause
# A toolchain file for the sanitizers: the clang of Debian 12, or else that of Debian 13.
find_program(MT_CLANG NAMES clang-14 clang-19 clang REQUIRED)
find_program(MT_CLANGXX NAMES clang++-14 clang++-19 clang++ REQUIRED)
mark_as_advanced(MT_CLANG MT_CLANGXX)
set(CMAKE_C_COMPILER "${MT_CLANG}")
set(CMAKE_CXX_COMPILER "${MT_CLANGXX}")
