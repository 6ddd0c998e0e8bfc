// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchOrder
 * @brief the order in which a patch is stored
 *
 * Triangles come as a front grows over them (vtkMTTriangleCodec), so that neighbours are near: good for compression and
 * for a GPU's vertex cache. Wedges are numbered as the triangles first use them (the *order of use*), points as the
 * wedges do; what no triangle uses comes last. In the patch itself points that can be shared come first, each group in
 * order of use, and wedges in order of point.
 */
#ifndef vtkMTPatchOrder_h
#define vtkMTPatchOrder_h

#include "vtkMTIOModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <vector>

namespace vtkMTTriangleCodec
{
struct Decoded;
}

struct VTKMTIO_EXPORT vtkMTPatchOrder
{
  vtkMTPatch Patch;                         ///< the same patch in the order of storage
  std::vector<unsigned char> Steps;         ///< its triangles, coded
  std::vector<unsigned char> Names;         ///< the same
  std::vector<std::uint32_t> WedgePoints;   ///< place in order of use of the point of each wedge, or empty
  std::vector<std::uint32_t> PointOfStream; ///< the patch's point for each one in order of use

  ///@{
  /// The patch must be consistent: every index in range. mesh: what the decoder will find of the triangles.
  static vtkMTPatchOrder Make(const vtkMTPatch& patch, vtkMTTriangleCodec::Decoded& mesh);
  static vtkMTPatchOrder Make(const vtkMTPatch& patch);
  ///@}

  /**
   * Final places from order of use: pointOfStream from the flags of shared points, then wedgeOfStream, the patch's
   * wedge for each one in order of use. wedgePoints is empty where wedge i is point i.
   */
  static std::vector<std::uint32_t> PlacePoints(const std::vector<unsigned char>& isShared);
  static std::vector<std::uint32_t> PlaceWedges(
    const std::vector<std::uint32_t>& wedgePoints, const std::vector<std::uint32_t>& pointOfStream);
};

#endif
