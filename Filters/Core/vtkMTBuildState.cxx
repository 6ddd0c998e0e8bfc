// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBuildState.h"

#include <string>

namespace
{
void PutArrays(vtkMTBytes::Writer& writer, const std::vector<vtkMTArrayInfo>& arrays)
{
  writer.Put<std::uint64_t>(arrays.size());
  for (const vtkMTArrayInfo& array : arrays)
  {
    writer.PutText(array.Name);
    writer.Put(array.Type);
    writer.Put(array.Components);
    writer.Put(array.Association);
    writer.Put(array.Resampling);
    writer.Put(array.Role);
    writer.Put(array.Attribute);
    writer.Put<std::uint64_t>(array.ComponentNames.size());
    for (const std::string& name : array.ComponentNames)
    {
      writer.PutText(name);
    }
    writer.Put<std::uint64_t>(array.Properties.size());
    for (const auto& [name, value] : array.Properties)
    {
      writer.PutText(name);
      writer.PutText(value);
    }
  }
}

void TakeArrays(vtkMTBytes::Reader& reader, std::vector<vtkMTArrayInfo>& arrays)
{
  arrays.clear();
  for (auto count = reader.Take<std::uint64_t>(); count > 0 && reader.IsSound(); --count)
  {
    vtkMTArrayInfo array;
    array.Name = reader.TakeText();
    array.Type = reader.Take<int>();
    array.Components = reader.Take<int>();
    array.Association = reader.Take<vtkMTArrayInfo::AssociationType>();
    array.Resampling = reader.Take<vtkMTArrayInfo::ResamplingType>();
    array.Role = reader.Take<vtkMTArrayInfo::RoleType>();
    array.Attribute = reader.Take<int>();
    for (auto names = reader.Take<std::uint64_t>(); names > 0 && reader.IsSound(); --names)
    {
      array.ComponentNames.push_back(reader.TakeText());
    }
    for (auto properties = reader.Take<std::uint64_t>(); properties > 0 && reader.IsSound(); --properties)
    {
      const std::string name = reader.TakeText();
      array.Properties[name] = reader.TakeText();
    }
    arrays.push_back(array);
  }
}
}

vtkMTBuildState::vtkMTBuildState() = default;

vtkMTBuildState::~vtkMTBuildState() = default;

void vtkMTBuildState::Save(vtkMTBytes::Writer& writer) const
{
  writer.Put(this->Level);
  writer.Put(this->Graph.Lattice);
  PutArrays(writer, this->Graph.Arrays);
  writer.Put(this->Graph.InputCounts);
  writer.PutCounts(this->Graph.InputReport);
  writer.PutCounts(this->Graph.Blocked);
  writer.Put(this->Graph.FullySharedBorders);
  writer.PutList(this->Nodes);
  writer.Put<std::uint64_t>(this->CertifiedArrays.size());
  for (const std::string& name : this->CertifiedArrays)
  {
    writer.PutText(name);
  }
  writer.PutList(this->CertifiedRanges);
  writer.PutList(this->NodeValueDeviations);
  writer.PutList(this->Arcs);
  writer.PutList(this->LevelElements);
}

void vtkMTBuildState::Load(vtkMTBytes::Reader& reader)
{
  this->Level = reader.Take<std::uint32_t>();
  this->Graph.Lattice = reader.Take<vtkMTLattice>();
  TakeArrays(reader, this->Graph.Arrays);
  this->Graph.InputCounts = reader.Take<vtkMTInputCounts>();
  reader.TakeCounts(this->Graph.InputReport);
  reader.TakeCounts(this->Graph.Blocked);
  this->Graph.FullySharedBorders = reader.Take<std::uint32_t>();
  reader.TakeList(this->Nodes);
  this->CertifiedArrays.clear();
  for (auto names = reader.Take<std::uint64_t>(); names > 0 && reader.IsSound(); --names)
  {
    this->CertifiedArrays.push_back(reader.TakeText());
  }
  reader.TakeList(this->CertifiedRanges);
  reader.TakeList(this->NodeValueDeviations);
  reader.TakeList(this->Arcs);
  reader.TakeList(this->LevelElements);
}
