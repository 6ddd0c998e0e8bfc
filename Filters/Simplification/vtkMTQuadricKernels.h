// SPDX-License-Identifier: BSD-3-Clause
/// @brief what vtkMTQuadrics does for four faces or edges at a time
#ifndef vtkMTQuadricKernels_h
#define vtkMTQuadricKernels_h

#include "vtkMTQuadrics.h"

namespace vtkMTQuadricKernels
{
using Quadric = vtkMTQuadrics::Quadric;

/// Of the faces of some half-edges, a multiple of four.
void MakeFaceQuadrics(
  const vtkMTCollapseRegion& region, const std::uint32_t* halfedges, std::size_t count, Quadric* ofFaces);
/// Of vertices, the sums of those of their faces, and their places.
void SumAroundVertices(const vtkMTCollapseMesh& mesh, const std::uint32_t* vertices, std::size_t count,
  const Quadric* ofFaces, vtkMTQuadrics::OfVertex* ofVertices);
/// See vtkMTQuadrics::Propose.
void Propose(const vtkMTCollapseRegion& region, const vtkMTQuadrics::Request* requests, std::size_t count,
  const vtkMTQuadrics::OfVertex* ofVertices, vtkMTQuadrics::Four* proposals);
}

#endif
