// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSelectionIds.h"

#include "vtkDataArray.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchAttributes.h"

#include <iterator>

vtkMTSelectionIds::vtkMTSelectionIds(const vtkMTGraph& graph, const vtkMTPatchArena& arena, vtkMTPatchCache& cache,
  int array, vtkMTPatchArena::DomainType domain)
  : Graph(graph)
  , Cache(cache)
  , Array(array)
  , Places(arena.GetPlaces(domain))
{
}

vtkMTSelectionIds::~vtkMTSelectionIds() = default;

vtkDataArray* vtkMTSelectionIds::GetValues(std::uint32_t arc)
{
  const auto found = this->Known.find(arc);
  if (found != this->Known.end())
  {
    return found->second.Array;
  }
  Values values;
  this->Cache.Request({ arc });
  values.Patch = this->Cache.Get(arc);
  if (values.Patch)
  {
    values.Array = vtkMTPatchAttributes::GetArray(this->Graph, this->Array, *values.Patch);
  }
  return this->Known.emplace(arc, values).first->second.Array;
}

vtkIdType vtkMTSelectionIds::GetId(std::uint64_t place)
{
  const auto unknown = static_cast<vtkIdType>(place);
  const auto next = this->Places.upper_bound(place);
  if (this->Array < 0 || next == this->Places.begin())
  {
    return unknown;
  }
  const auto found = std::prev(next);
  vtkDataArray* values = this->GetValues(found->second);
  const auto tuple = static_cast<vtkIdType>(place - found->first);
  return values && tuple < values->GetNumberOfTuples() ? static_cast<vtkIdType>(values->GetComponent(tuple, 0))
                                                       : unknown;
}

void vtkMTSelectionIds::Translate(const std::vector<unsigned int>& offsets, const unsigned char* lowPlaces,
  const unsigned char* highPlaces, std::uint64_t primitives, bool high, unsigned char* target)
{
  for (const unsigned int at : offsets)
  {
    const std::uint64_t top = highPlaces ? highPlaces[at] : 0;
    const std::uint64_t written =
      (top << 24) | (std::uint64_t(lowPlaces[at + 2]) << 16) | (std::uint64_t(lowPlaces[at + 1]) << 8) | lowPlaces[at];
    const auto id = static_cast<std::uint64_t>(this->GetId(written / primitives));
    const std::uint64_t part = high ? id >> 24 : id;
    target[at] = part & 0xff;
    target[at + 1] = (part >> 8) & 0xff;
    target[at + 2] = (part >> 16) & 0xff;
  }
}
