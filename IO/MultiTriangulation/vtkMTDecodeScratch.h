// SPDX-License-Identifier: BSD-3-Clause
// How the triangles and wedges of a packed patch were met. Not installed.
#ifndef vtkMTDecodeScratch_h
#define vtkMTDecodeScratch_h

#include "vtkMTIdCodec.h"
#include "vtkMTPositionCodec.h"
#include "vtkMTTriangleCodec.h"

#include <cstdint>
#include <vector>

/**
 * From here the arrays of a patch know their neighbours, from which they are expected. It is filled with the geometry
 * and belongs to one thread; what it holds besides is memory that is worth keeping from patch to patch.
 */
struct vtkMTDecodeScratch
{
  bool IsKnown = false; ///< not where the geometry was raw
  vtkMTTriangleCodec::Decoded Mesh;
  std::vector<std::uint32_t> WedgeOfStream; ///< the patch's wedge for each one in order of use

  std::vector<unsigned char> Stored; ///< sections as they are in the file
  std::vector<unsigned char> Bytes;  ///< the geometry's streams
  std::vector<std::uint32_t> WedgePoints;
  std::vector<std::uint32_t> PointOfStream;
  std::vector<std::uint32_t> StreamOfPoint;
  std::vector<vtkMTTriangleCodec::Basis> PointBases;
  std::vector<vtkMTPositionCodec::Wide> Places;
  std::vector<vtkMTIdCodec::Identity> Identities;
  std::vector<std::uint32_t> BorderOrder;
  std::vector<unsigned char> IsMarked; ///< of points
};

#endif
