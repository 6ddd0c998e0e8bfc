// SPDX-License-Identifier: BSD-3-Clause
// The strings of a Multi-Triangulation file: arrays, settings, reports. Not installed.
#ifndef vtkMTFileMetadata_h
#define vtkMTFileMetadata_h

#include "vtkMTGraph.h"

#include <cstdint>
#include <vector>

namespace vtkMTFileMetadata
{
std::vector<unsigned char> Encode(const vtkMTGraph& graph);

struct Counts
{
  std::uint32_t Arrays;
  std::uint32_t Blobs;
};

/// Fills the graph's arrays, blobs, settings and reports. False when the bytes are not exactly such ones, or of types
/// that this machine does not have.
bool Decode(const unsigned char* data, std::uint64_t size, const Counts& counts, vtkMTGraph& graph);
}

#endif
