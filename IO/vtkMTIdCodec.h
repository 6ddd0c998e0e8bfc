// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which points of a patch can be shared, and their identities, as runs along its border. Not installed.
 *
 * Shared points are on the border of a patch as a rule, and identities that were given together follow each other
 * there: the builder numbers them along borders. So the points are taken in *border order*, and said in runs: of points
 * that are not shared, or of identities that grow or fall by one. Points of other patches cost more, but can be said
 * all the same.
 */
#ifndef vtkMTIdCodec_h
#define vtkMTIdCodec_h

#include "vtkMTNumberCode.h"

#include <cstdint>
#include <vector>

namespace vtkMTIdCodec
{
/// The points on the border, each once, then all others in stream order. border: vertices, which may be there more than
/// once; wedgePoints: their points, or empty when they are the points.
std::vector<std::uint32_t> GetBorderOrder(
  const std::vector<std::uint32_t>& border, const std::vector<std::uint32_t>& wedgePoints, std::size_t points);

/// What is said of all points, in stream order.
struct Identities
{
  std::vector<unsigned char> IsShared;
  std::vector<std::uint64_t> Ids; ///< of the points that are shared; of no meaning elsewhere
};

void Append(
  const Identities& identities, const std::vector<std::uint32_t>& borderOrder, std::vector<unsigned char>& side);

/// `shared` of the points of borderOrder get an identity. False when the bytes are no such runs.
bool Read(vtkMTNumberCode::Reader& side, const std::vector<std::uint32_t>& borderOrder, std::uint32_t shared,
  Identities& identities);
}

#endif
