// SPDX-License-Identifier: BSD-3-Clause
// A patch as the sections of a Multi-Triangulation file: one for its geometry, one for each array. Not installed.
#ifndef vtkMTPatchCodec_h
#define vtkMTPatchCodec_h

#include "vtkMTFileFormat.h"
#include "vtkMTGraph.h"
#include "vtkMTPatch.h"

#include <string>
#include <vector>

namespace vtkMTPatchCodec
{
/**
 * Replaces bytes by the patch's sections, each padded to the alignment, and sections by their records, whose offsets
 * count from the first of these bytes. False when the patch is inconsistent.
 */
bool Encode(const vtkMTPatch& patch, const std::vector<vtkMTArrayInfo>& arrays, std::vector<unsigned char>& bytes,
  std::vector<vtkMTFileFormat::SectionRecord>& sections, std::string& error);

/// Whether a section's bytes (with padding) are as they were written, and of a codec that is known here.
bool Check(const vtkMTFileFormat::SectionRecord& section, const unsigned char* padded, std::string& error);

/// The geometry of an arc's patch from its raw bytes. Nothing is allocated before the size has been found right.
bool DecodeGeometry(
  const unsigned char* data, std::uint64_t size, const vtkMTArc& arc, vtkMTPatch& patch, std::string& error);

/// An array's column from its raw bytes.
bool DecodeColumn(const unsigned char* data, std::uint64_t size, const vtkMTArc& arc, const vtkMTArrayInfo& array,
  vtkMTColumn& column, std::string& error);
}

#endif
