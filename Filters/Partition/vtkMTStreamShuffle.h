// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTStreamShuffle
 * @brief the beginning of a mesh's barycentres in an order that looks like chance
 *
 * As the inserters of Nexus do it (Cignoni et al.; its notes on streams): there are about log2 N streams, and a
 * triangle goes to stream n with probability 1 / 2^(n+1). Read from the rarest stream to the commonest, every beginning
 * of the whole is an even sample of the mesh, whatever order the file had. Which stream a triangle goes to follows from
 * a hash of its number, so the order is always the same. Here the streams are not written anywhere: a scan is
 * repeatable, and the beginning that holds one of 2^k triangles is what the streams from k on hold.
 */
#ifndef vtkMTStreamShuffle_h
#define vtkMTStreamShuffle_h

#include "vtkMTPartition.h"
#include "vtkMTPartitionModule.h" // For export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class VTKMTPARTITION_EXPORT vtkMTStreamShuffle
{
public:
  using Point = std::array<double, 3>;
  static constexpr int MaximumStream = 40;

  /// The stream of the triangle with this number, from 0 to MaximumStream.
  static int GetStream(std::uint64_t number);

  /**
   * The finite barycentres of the streams from firstStream on, the rarest stream first and each in the order of the
   * scan: about one of 2^firstStream. At least one where there are any. False when the scan failed.
   */
  bool Take(vtkMTBarycentreScan& scan, int firstStream);

  std::vector<Point> Points;
  std::size_t Count = 0; ///< of all finite barycentres
};

#endif
