// SPDX-License-Identifier: BSD-3-Clause
// The metadata of a Multi-Triangulation file: lattice, figures, arrays, ranges, settings, reports. Not installed.
#ifndef vtkMTFileMetadata_h
#define vtkMTFileMetadata_h

#include "vtkMTGraph.h"

#include <cstdint>
#include <vector>

namespace vtkMTFileMetadata
{
/// What is stored there and is not the graph's, or not when it is written.
struct Extras
{
  std::vector<std::vector<vtkMTRange>> ArrayRanges; ///< one for each array, or none: then they are empty
  std::vector<std::uint64_t> BlobOffsets;           ///< one for each blob
};

std::vector<unsigned char> Encode(const vtkMTGraph& graph, const Extras& extras);

/// Fills everything of the graph that is not by node or by arc: names of measures and columns of ranges, without their
/// values. False when the bytes are not exactly such ones, or of types that this machine does not have.
bool Decode(const unsigned char* data, std::uint64_t size, vtkMTGraph& graph, Extras& extras);
}

#endif
