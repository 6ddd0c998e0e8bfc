// SPDX-License-Identifier: BSD-3-Clause
// Header and DAG block of a Multi-Triangulation file: everything before the first patch. Not installed.
#ifndef vtkMTFileDag_h
#define vtkMTFileDag_h

#include "vtkMTFileFormat.h"
#include "vtkMTGraph.h"

#include <string>
#include <vector>

class vtkMTByteSource;

namespace vtkMTFileDag
{
/// Whether the graph's indices, counts and numbers are such that they can be used without further checks.
bool Check(const vtkMTGraph& graph, std::string& error);

/**
 * The bytes of header and DAG block. directory has 1 + number of arrays sections per arc, in arc order, then one per
 * blob.
 */
void Encode(const vtkMTGraph& graph, const std::vector<vtkMTFileFormat::SectionRecord>& directory,
  std::vector<unsigned char>& bytes);

/// Reads and checks header and DAG block; no more memory is asked for than the file has bytes, times a small factor.
bool Decode(const vtkMTByteSource& bytes, vtkMTGraph& graph, std::vector<vtkMTFileFormat::Section>& directory,
  std::string& error);

/// Whether a file that begins with these bytes is a Multi-Triangulation file, of whatever version.
bool HasMagic(const unsigned char* bytes, std::size_t count);
}

#endif
