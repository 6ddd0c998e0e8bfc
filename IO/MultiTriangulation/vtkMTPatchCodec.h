// SPDX-License-Identifier: BSD-3-Clause
// A patch as the sections of a Multi-Triangulation file: one for its geometry, one for each array. Not installed.
#ifndef vtkMTPatchCodec_h
#define vtkMTPatchCodec_h

#include "vtkMTFileFormat.h"
#include "vtkMTFileTables.h"
#include "vtkMTGraph.h"
#include "vtkMTPatch.h"
#include "vtkMTRiceCode.h"

#include <cstddef>
#include <string>
#include <vector>

struct vtkMTDecodeScratch;

namespace vtkMTPatchCodec
{
/**
 * Replaces bytes by the patch's sections, each padded to the alignment, and sections by their records, whose offsets
 * count from the first of these bytes. Columns without bytes have no section, a patch without points has none at all.
 * The patch is put into the order of storage (vtkMTPatchOrder). False when it is inconsistent, too large or of a kind
 * for which there is no codec.
 */
bool Encode(const vtkMTPatch& patch, const std::vector<vtkMTArrayInfo>& arrays, vtkMTFileFormat::Codec codec,
  std::vector<unsigned char>& bytes, std::vector<vtkMTFileSection>& sections, std::string& error);

/// Whether a section's bytes (with padding) are as they were written, and of a codec that is known here.
bool Check(const vtkMTFileFormat::SectionRecord& section, const unsigned char* padded, std::string& error);

/// So many bytes behind a section can be read while it is decoded. What they are does not matter.
constexpr std::size_t Slack = vtkMTRiceCode::Reader::Slack;

/// The geometry of an arc's patch from its section's bytes, and how its triangles were met. Nothing is allocated before
/// the sizes have been found right.
bool DecodeGeometry(const vtkMTFileFormat::SectionRecord& section, const unsigned char* data, const vtkMTArc& arc,
  vtkMTDecodeScratch& traversal, vtkMTPatch& patch, std::string& error);

/// Whether an array of the arc's patch may have no section: it has no values there.
bool MayBeMissing(const vtkMTGraph& graph, std::uint32_t arc, const vtkMTArrayInfo& array);

/// An array's column from its section's bytes, after the geometry of the same patch, which it may be one of; Slack
/// bytes behind them can be read, too.
bool DecodeColumn(const vtkMTFileFormat::SectionRecord& section, const unsigned char* data, const vtkMTArc& arc,
  const vtkMTArrayInfo& array, const vtkMTPatch& patch, const vtkMTDecodeScratch& traversal, vtkMTColumn& column,
  std::string& error);
}

#endif
