// SPDX-License-Identifier: BSD-3-Clause
/**
 * The geometry section of a patch that is compressed. Not installed.
 *
 * A record, then the *side bytes*, which LZ4 or zstd has made smaller, then the bits of the positions
 * (vtkMTPositionCodec), which nothing makes smaller. The side bytes hold the triangles (vtkMTTriangleCodec), a bit
 * per point that says whether it can be shared, the wedges' points, the identities, and what the positions need besides
 * their bits. Points and wedges are in order of use there (vtkMTPatchOrder).
 */
#ifndef vtkMTPackedGeometry_h
#define vtkMTPackedGeometry_h

#include "vtkMTFileFormat.h"
#include "vtkMTPatch.h"

#include <string>
#include <vector>

struct vtkMTArc;
struct vtkMTPatchOrder;
struct vtkMTDecodeScratch;

namespace vtkMTPackedGeometry
{
/// Both say how the triangles were met. Appends a consistent patch's geometry, of which the traversal has the mesh
/// already (vtkMTPatchOrder::Make). False when it is too large for the codec.
bool Encode(const vtkMTPatchOrder& order, vtkMTFileFormat::Codec codec, std::vector<unsigned char>& bytes,
  vtkMTDecodeScratch& traversal);

/// vtkMTRiceCode::Reader::Slack bytes behind the data can be read.
bool Decode(vtkMTFileFormat::Codec codec, const unsigned char* data, std::uint64_t size, const vtkMTArc& arc,
  vtkMTDecodeScratch& traversal, vtkMTPatch& patch, std::string& error);
}

#endif
