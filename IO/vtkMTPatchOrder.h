// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchOrder
 * @brief the order in which a patch is stored
 *
 * Triangles are put into an order that is good for a GPU's vertex cache and for compression at once (meshoptimizer's
 * vertex cache optimisation for strips) and are turned as its index codec turns them. Wedges are numbered as the
 * triangles first use them (the *stream order*), points as the wedges do; what no triangle uses comes last. In the
 * patch itself points that can be shared come first, each group in stream order, and wedges in order of point. A patch
 * that is in such an order already, as files give them, keeps it.
 */
#ifndef vtkMTPatchOrder_h
#define vtkMTPatchOrder_h

#include "vtkMTIOModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <vector>

struct VTKMTIO_EXPORT vtkMTPatchOrder
{
  vtkMTPatch Patch; ///< the same patch in the order of storage
  std::vector<unsigned char>
    Indices; ///< the triangles' wedges in stream order, as meshoptimizer's index codec has them
  std::vector<vtkMTTriangle> StreamTriangles; ///< the same, not coded
  std::vector<std::uint32_t> WedgePoints;     ///< stream order of points for each wedge in stream order
  std::vector<std::uint32_t> PointOfStream;   ///< the patch's point for each one in stream order

  /// The patch must be consistent: every index in range.
  static vtkMTPatchOrder Make(const vtkMTPatch& patch);

  /// The codec's inverse: fills triangles, whose number is given. False when the bytes are damaged.
  static bool DecodeIndices(
    const unsigned char* bytes, std::size_t size, std::uint32_t wedges, std::vector<vtkMTTriangle>& triangles);

  /**
   * Final places from stream order: pointOfStream from the flags of shared points, then wedgeOfStream, the patch's
   * wedge for each one in stream order. wedgePoints is empty where wedge i is point i.
   */
  static std::vector<std::uint32_t> PlacePoints(const std::vector<unsigned char>& isShared);
  static std::vector<std::uint32_t> PlaceWedges(
    const std::vector<std::uint32_t>& wedgePoints, const std::vector<std::uint32_t>& pointOfStream);
};

#endif
