// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRegionSpool.h"

#include "vtkMTBytes.h"

namespace
{
enum KindType : unsigned char
{
  PatchKind = 1,
  LocksKind = 2
};

bool TakeRecord(vtkMTBytes::Reader& reader, vtkMTRegionRecords& records)
{
  switch (reader.Take<unsigned char>())
  {
    case PatchKind:
      records.Patches.emplace_back();
      return records.Patches.back().Take(reader) && reader.IsAtEnd();
    case LocksKind:
      reader.TakeList(records.Locks);
      return reader.IsSound() && reader.IsAtEnd();
    default:
      return false;
  }
}
}

bool vtkMTRegionSpool::Begin(vtkMTSpoolStore& store, const std::string& name, std::size_t regions, std::string& error)
{
  return this->Records.Begin(store, name, regions, error);
}

void vtkMTRegionSpool::EncodePatch(const vtkMTCertifiedMesh& patch, Bytes& bytes)
{
  bytes.clear();
  bytes.reserve(patch.Mesh.GetMemorySize() + patch.Deviations.size() * sizeof(vtkMTTriangleDeviation) +
    patch.ValueDeviations.size() * sizeof(vtkMTValueDeviation) + 256);
  vtkMTBytes::Writer writer(bytes);
  writer.Put(PatchKind);
  patch.Put(writer);
}

bool vtkMTRegionSpool::PutPatch(std::size_t region, const Bytes& patch, std::string& error)
{
  return this->Records.Put(region, patch.data(), patch.size(), error);
}

bool vtkMTRegionSpool::PutLocks(std::size_t region, const std::vector<std::uint64_t>& locks, std::string& error)
{
  Bytes bytes;
  vtkMTBytes::Writer writer(bytes);
  writer.Put(LocksKind);
  writer.PutList(locks);
  return this->Records.Put(region, bytes.data(), bytes.size(), error);
}

bool vtkMTRegionSpool::Seal(std::string& error)
{
  return this->Records.Seal(error);
}

bool vtkMTRegionSpool::Take(std::size_t region, vtkMTRegionRecords& records, std::string& error) const
{
  records = vtkMTRegionRecords();
  std::vector<vtkMTBytes::Record> stored;
  if (!this->Records.Take(region, stored, error))
  {
    return false;
  }
  records.Patches.reserve(stored.size());
  for (vtkMTBytes::Record& record : stored)
  {
    vtkMTBytes::Reader reader(record);
    if (!TakeRecord(reader, records))
    {
      error = "temporary data does not hold the region that was written";
      return false;
    }
    record = {};
  }
  return true;
}

bool vtkMTRegionSpool::Open(vtkMTSpoolStore& store, const std::string& name, const Bytes& state, std::string& error)
{
  return this->Records.Open(store, name, state, error);
}
