// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSelectionIds.h"

#include "vtkDataArray.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchAttributes.h"

#include <iterator>

vtkMTSelectionIds::vtkMTSelectionIds(const vtkMTGraph& graph, const vtkMTPatchArena& arena, vtkMTPatchCache& cache,
  int array, vtkMTPatchArena::DomainType domain)
  : Graph(graph)
  , Arena(arena)
  , Cache(cache)
  , Array(array)
  , Domain(domain)
  , Places(arena.GetPlaces(domain))
{
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
  const std::uint32_t arc = found->second;
  auto patch = this->Patches.find(arc);
  if (patch == this->Patches.end())
  {
    this->Cache.Request({ arc });
    patch = this->Patches.emplace(arc, this->Cache.Get(arc)).first;
  }
  if (!patch->second)
  {
    return unknown;
  }
  const auto array = vtkMTPatchAttributes::GetArray(this->Graph, this->Array, *patch->second);
  const auto tuple = static_cast<vtkIdType>(place - found->first);
  return tuple < array->GetNumberOfTuples() ? static_cast<vtkIdType>(array->GetComponent(tuple, 0)) : unknown;
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
