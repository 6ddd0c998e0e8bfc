// SPDX-License-Identifier: BSD-3-Clause
// The checksum of models and checkpoints. Not installed.
#ifndef vtkMTChecksum_h
#define vtkMTChecksum_h

#include "vtkMTIOCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>

/// XXH3-64 with seed 0 (xxHash 0.8).
VTKMTIOCORE_EXPORT std::uint64_t vtkMTChecksum(const void* data, std::size_t size);

#endif
