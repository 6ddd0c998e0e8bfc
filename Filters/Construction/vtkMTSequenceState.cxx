// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSequenceState.h"

vtkMTSequenceState::vtkMTSequenceState() = default;

vtkMTSequenceState::~vtkMTSequenceState() = default;

void vtkMTSequenceState::Save(std::vector<unsigned char>& bytes) const
{
  vtkMTBytes::Writer writer(bytes);
  this->vtkMTBuildState::Save(writer);
  writer.Put(this->Stage);
  writer.Put(this->FirstArcOfLevel);
  writer.PutList(this->NodeOfFragment);
  writer.Put(this->NextRegions);
  writer.Put(this->SimplifiedTriangles);
  writer.Put(this->FeatureAngle);
  writer.Put(this->AutomaticFeatureAngle);
  writer.PutText(this->DihedralAngles);
  std::vector<unsigned char> records;
  if (this->Stage == HasPatches)
  {
    this->Patches.Save(records);
  }
  else
  {
    this->Fragments.Save(records);
  }
  writer.PutList(records);
  std::vector<unsigned char> finer;
  this->Finer.Save(finer);
  writer.PutList(finer);
}

bool vtkMTSequenceState::Load(vtkMTSpoolStore& store, const std::vector<unsigned char>& bytes, std::string& error)
{
  vtkMTBytes::Reader reader(bytes);
  this->vtkMTBuildState::Load(reader);
  this->Stage = reader.Take<StageType>();
  this->FirstArcOfLevel = reader.Take<std::uint64_t>();
  reader.TakeList(this->NodeOfFragment);
  this->NextRegions = reader.Take<std::uint32_t>();
  this->SimplifiedTriangles = reader.Take<std::uint64_t>();
  this->FeatureAngle = reader.Take<double>();
  this->AutomaticFeatureAngle = reader.Take<double>();
  this->DihedralAngles = reader.TakeText();
  std::vector<unsigned char> records;
  reader.TakeList(records);
  std::vector<unsigned char> finer;
  reader.TakeList(finer);
  if (!reader.IsSound() || !reader.IsAtEnd() || this->LevelElements.empty())
  {
    error = "the checkpoint does not hold what was kept";
    return false;
  }
  if (!this->Finer.Open(store, *this, this->Stage == HasPatches, finer, error))
  {
    return false;
  }
  if (this->Stage == HasPatches)
  {
    return this->Patches.Open(store, GetPatchesName(this->Level), records, error);
  }
  return this->Fragments.Open(store, GetFragmentsName(this->Level), records, error);
}
