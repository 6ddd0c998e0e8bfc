// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which points of a patch can be shared, and their identities, as runs along its border. Not installed.
 *
 * Shared points are on the border of a patch as a rule, and identities that were given together follow each other
 * there: the builder numbers them along borders. So the points are taken in *border order*, and encoded in runs: of
 * points that are not shared, or of identities that grow or fall by one. Points of other patches cost more, but can
 * be encoded all the same.
 */
#ifndef vtkMTIdCodec_h
#define vtkMTIdCodec_h

#include "vtkMTNumberCode.h"

#include <cstdint>
#include <vector>

namespace vtkMTIdCodec
{
/// The points on the border, each once. border: vertices, which may be there more than once; wedgePoints: their points,
/// or empty when they are the points. All others follow in order of use; AppendOthers puts them there.
/// isMet: memory to work with.
void GetBorderOrder(const std::vector<std::uint32_t>& border, const std::vector<std::uint32_t>& wedgePoints,
  std::size_t points, std::vector<unsigned char>& isMet, std::vector<std::uint32_t>& order);
void AppendOthers(std::vector<std::uint32_t>& borderOrder, std::size_t points);

/// Of the points that are shared, in any order.
struct Identity
{
  std::uint32_t Point; ///< in order of use
  std::uint64_t Id;
};

/// identities: of points of borderOrder, which holds all points, in the order of it.
void Append(const std::vector<Identity>& identities, const std::vector<std::uint32_t>& borderOrder,
  std::vector<unsigned char>& side);

/// Gives the identities of `shared` points. borderOrder is completed when it is needed. False when the bytes are no
/// such runs.
bool Read(vtkMTNumberCode::Reader& side, std::vector<std::uint32_t>& borderOrder, std::size_t points,
  std::uint32_t shared, std::vector<Identity>& identities);
}

#endif
