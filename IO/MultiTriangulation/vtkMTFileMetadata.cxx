// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileMetadata.h"

#include "vtkMTExactPoints.h"

#include <cstring>

namespace
{
class MetadataWriter
{
public:
  template <typename Number>
  void Put(Number value)
  {
    const unsigned char* from = reinterpret_cast<const unsigned char*>(&value);
    this->Bytes.insert(this->Bytes.end(), from, from + sizeof(value));
  }
  void Put(const std::string& text)
  {
    this->Put(static_cast<std::uint32_t>(text.size()));
    this->Bytes.insert(this->Bytes.end(), text.begin(), text.end());
  }
  template <typename Value>
  void Put(const std::map<std::string, Value>& map)
  {
    this->Put(static_cast<std::uint32_t>(map.size()));
    for (const auto& entry : map)
    {
      this->Put(entry.first);
      this->Put(entry.second);
    }
  }
  void Put(const vtkMTArrayInfo& array)
  {
    this->Put(array.Name);
    this->Put(static_cast<std::int32_t>(array.Type));
    this->Put(static_cast<std::int32_t>(array.Components));
    this->Put(static_cast<std::int32_t>(array.Attribute));
    this->Put(static_cast<std::uint32_t>(array.GetTupleSize()));
    this->Put(static_cast<std::uint8_t>(array.Association));
    this->Put(static_cast<std::uint8_t>(array.Resampling));
    this->Put(static_cast<std::uint8_t>(array.Role));
    this->Put(static_cast<std::uint8_t>(0));
    this->Put(static_cast<std::uint32_t>(array.ComponentNames.size()));
    for (const std::string& name : array.ComponentNames)
    {
      this->Put(name);
    }
    this->Put(array.Properties);
  }

  std::vector<unsigned char> Bytes;
};

class MetadataReader
{
public:
  MetadataReader(const unsigned char* data, std::uint64_t size)
    : Next(data)
    , Left(size)
  {
  }

  template <typename Number>
  bool Get(Number& value)
  {
    if (this->Left < sizeof(value))
    {
      return false;
    }
    std::memcpy(&value, this->Next, sizeof(value));
    this->Next += sizeof(value);
    this->Left -= sizeof(value);
    return true;
  }
  bool Get(std::string& text)
  {
    std::uint32_t size = 0;
    if (!this->Get(size) || size > this->Left)
    {
      return false;
    }
    text.assign(reinterpret_cast<const char*>(this->Next), size);
    this->Next += size;
    this->Left -= size;
    return true;
  }
  template <typename Value>
  bool Get(std::map<std::string, Value>& map)
  {
    std::uint32_t count = 0;
    if (!this->Get(count))
    {
      return false;
    }
    for (std::uint32_t i = 0; i < count; ++i)
    {
      std::string key;
      Value value{};
      if (!this->Get(key) || !this->Get(value) || !map.emplace(std::move(key), std::move(value)).second)
      {
        return false;
      }
    }
    return true;
  }
  bool Get(vtkMTArrayInfo& array)
  {
    std::int32_t type = 0;
    std::int32_t components = 0;
    std::int32_t attribute = 0;
    std::uint32_t tupleSize = 0;
    std::uint8_t kinds[4];
    std::uint32_t names = 0;
    if (!this->Get(array.Name) || !this->Get(type) || !this->Get(components) || !this->Get(attribute) ||
      !this->Get(tupleSize) || !this->Get(kinds) || !this->Get(names) || components < 1 ||
      kinds[0] > vtkMTArrayInfo::Cell || kinds[1] > vtkMTArrayInfo::Direction ||
      kinds[2] > vtkMTArrayInfo::ExactPoints || kinds[3] != 0 ||
      (names != 0 && names != static_cast<std::uint32_t>(components)))
    {
      return false;
    }
    array.Type = type;
    array.Components = components;
    array.Attribute = attribute;
    array.Association = static_cast<vtkMTArrayInfo::AssociationType>(kinds[0]);
    array.Resampling = static_cast<vtkMTArrayInfo::ResamplingType>(kinds[1]);
    array.Role = static_cast<vtkMTArrayInfo::RoleType>(kinds[2]);
    for (std::uint32_t i = 0; i < names; ++i)
    {
      array.ComponentNames.emplace_back();
      if (!this->Get(array.ComponentNames.back()))
      {
        return false;
      }
    }
    if (!this->Get(array.Properties) ||
      (array.Role == vtkMTArrayInfo::ExactPoints && !vtkMTExactPoints::IsSound(array)))
    {
      return false;
    }
    // A type whose size is another one here (long) cannot be read on this machine.
    return tupleSize > 0 && array.GetTupleSize() == tupleSize;
  }
  bool IsAtEnd() const { return this->Left == 0; }

private:
  const unsigned char* Next;
  std::uint64_t Left;
};
}

std::vector<unsigned char> vtkMTFileMetadata::Encode(const vtkMTGraph& graph)
{
  MetadataWriter writer;
  for (const vtkMTArrayInfo& array : graph.Arrays)
  {
    writer.Put(array);
  }
  for (const vtkMTBlobInfo& blob : graph.Blobs)
  {
    writer.Put(blob.Name);
    writer.Put(blob.Type);
    writer.Put(blob.Properties);
  }
  writer.Put(graph.Settings);
  writer.Put(graph.InputReport);
  writer.Put(graph.Blocked);
  return writer.Bytes;
}

bool vtkMTFileMetadata::Decode(const unsigned char* data, std::uint64_t size, const Counts& counts, vtkMTGraph& graph)
{
  MetadataReader reader(data, size);
  for (std::uint32_t i = 0; i < counts.Arrays; ++i)
  {
    graph.Arrays.emplace_back();
    if (!reader.Get(graph.Arrays.back()))
    {
      return false;
    }
  }
  for (std::uint32_t i = 0; i < counts.Blobs; ++i)
  {
    graph.Blobs.emplace_back();
    vtkMTBlobInfo& blob = graph.Blobs.back();
    if (!reader.Get(blob.Name) || !reader.Get(blob.Type) || !reader.Get(blob.Properties))
    {
      return false;
    }
  }
  return reader.Get(graph.Settings) && reader.Get(graph.InputReport) && reader.Get(graph.Blocked) && reader.IsAtEnd();
}
