// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchStore.h"

#include "vtkMTRangeCollector.h"

#include <utility>

//------------------------------------------------------------------------------
bool vtkMTPatchStore::Begin(const std::vector<vtkMTArrayInfo>& arrays)
{
  this->Abandon();
  this->Error.clear();
  this->Graph.Arrays = arrays;
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTPatchStore::WritePatch(vtkMTPatch&& patch)
{
  this->Patches.push_back(std::move(patch));
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTPatchStore::WriteBlob(std::vector<unsigned char>&& bytes)
{
  this->Blobs.push_back(std::move(bytes));
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTPatchStore::ReadBlob(std::uint32_t blob, std::vector<unsigned char>& bytes, std::string& error) const
{
  if (blob >= this->Blobs.size())
  {
    return this->vtkMTPatchSource::ReadBlob(blob, bytes, error);
  }
  bytes = this->Blobs[blob];
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTPatchStore::Finish(const vtkMTGraph& graph, const std::vector<std::uint32_t>& patchOfArc)
{
  const std::size_t count = this->Patches.size();
  bool matches =
    patchOfArc.size() == graph.Arcs.size() && count == graph.Arcs.size() && this->Blobs.size() == graph.Blobs.size();
  std::vector<bool> used(count, false);
  for (std::size_t arc = 0; matches && arc < count; ++arc)
  {
    matches = patchOfArc[arc] < count && !used[patchOfArc[arc]];
    if (matches)
    {
      used[patchOfArc[arc]] = true;
    }
  }
  if (!matches)
  {
    this->Abandon();
    this->Error = "Patch store: " + std::to_string(count) + " patches do not belong one to one to " +
      std::to_string(graph.Arcs.size()) + " arcs, or blobs to their descriptions";
    return false;
  }
  std::vector<vtkMTPatch> ordered;
  ordered.reserve(count);
  for (std::uint32_t patch : patchOfArc)
  {
    ordered.push_back(std::move(this->Patches[patch]));
  }
  this->Patches.swap(ordered);
  this->Graph = graph;
  vtkMTRangeCollector ranges(this->Graph);
  for (std::uint32_t arc = 0; arc < count; ++arc)
  {
    if (ranges.Wants(arc))
    {
      ranges.Add(arc, this->Patches[arc].GetRanges(this->Graph.Arrays));
    }
  }
  ranges.Finish();
  this->Graph.ArrayRanges = ranges.GetArrayRanges();
  this->Graph.ArcRanges = ranges.GetArcRanges();
  return true;
}

//------------------------------------------------------------------------------
void vtkMTPatchStore::Abandon()
{
  this->Graph = vtkMTGraph();
  this->Patches.clear();
  this->Blobs.clear();
}

//------------------------------------------------------------------------------
bool vtkMTPatchStore::ReadPatch(
  std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const
{
  patch = vtkMTPatch();
  const std::vector<vtkMTArrayInfo>& infos = this->Graph.Arrays;
  if (arc >= this->Patches.size() || (arrays && arrays->size() != infos.size()))
  {
    error = arc >= this->Patches.size() ? "memory: no arc " + std::to_string(arc)
                                        : "memory: the choice of arrays has the wrong length";
    return false;
  }
  const vtkMTPatch& stored = this->Patches[arc];
  if (!arrays)
  {
    patch = stored;
    return true;
  }
  patch.Kind = stored.Kind;
  patch.Points = stored.Points;
  patch.Ids = stored.Ids;
  patch.WedgePoints = stored.WedgePoints;
  patch.Triangles = stored.Triangles;
  patch.PointColumns.resize(stored.PointColumns.size());
  patch.CellColumns.resize(stored.CellColumns.size());
  std::size_t column[2] = { 0, 0 };
  for (std::size_t i = 0; i < infos.size(); ++i)
  {
    const bool cell = infos[i].Association == vtkMTArrayInfo::Cell;
    const std::vector<vtkMTColumn>& from = cell ? stored.CellColumns : stored.PointColumns;
    const std::size_t index = column[cell]++;
    if ((*arrays)[i] && index < from.size())
    {
      (cell ? patch.CellColumns : patch.PointColumns)[index] = from[index];
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::uint64_t vtkMTPatchStore::GetPatchSize(std::uint32_t arc) const
{
  return arc < this->Patches.size() ? this->Patches[arc].GetMemorySize() : 0;
}
