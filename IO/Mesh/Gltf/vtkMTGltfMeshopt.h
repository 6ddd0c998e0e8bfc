// SPDX-License-Identifier: BSD-3-Clause
// EXT_meshopt_compression, where meshoptimizer was found (MT_WITH_MESHOPTIMIZER). Not installed.
#ifndef vtkMTGltfMeshopt_h
#define vtkMTGltfMeshopt_h

#include "vtkMTGltfJson.h"

namespace vtkMTGltfMeshopt
{
bool IsAvailable();

/// The extension of a view or a buffer, or null.
const vtkMTGltfJson::Json* FindExtension(const vtkMTGltfJson::Json& object);

/// Decodes a view of length bytes; all modes and filters. Throws vtkMTGltfJson::Error.
std::vector<unsigned char> Decode(const vtkMTGltfJson::Json& extension, const std::vector<unsigned char>& compressed,
  std::uint64_t length, const std::string& where);
}

#endif
