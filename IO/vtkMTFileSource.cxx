// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileSource.h"

#include "vtkMTFileByteSource.h"
#include "vtkMTFileDag.h"
#include "vtkMTPatchCodec.h"

#include <new>

using vtkMTFileFormat::Align;
using vtkMTFileFormat::Section;

struct vtkMTFileSource::Internals
{
  std::shared_ptr<const vtkMTByteSource> Bytes;
  std::vector<Section> Directory;

  const Section* SectionsOf(std::uint32_t arc, std::size_t arrays) const
  {
    return this->Directory.data() + std::size_t(arc) * (arrays + 1);
  }

  // Reads the wanted sections of a patch, neighbours together, and hands each one to use(index, its bytes).
  template <typename Use>
  bool Read(const Section* sections, const std::vector<unsigned char>& wanted, std::string& error, Use&& use) const
  {
    std::vector<unsigned char> buffer;
    for (std::size_t first = 0; first < wanted.size();)
    {
      if (!wanted[first])
      {
        ++first;
        continue;
      }
      std::size_t end = first;
      std::size_t size = 0;
      for (; end < wanted.size() && wanted[end]; ++end)
      {
        size += static_cast<std::size_t>(Align(sections[end].StoredSize));
      }
      buffer.resize(size);
      if (!this->Bytes->Read(sections[first].Offset, size, buffer.data(), error))
      {
        return false;
      }
      const unsigned char* data = buffer.data();
      for (; first < end; ++first)
      {
        if (!vtkMTPatchCodec::Check(sections[first], data, error) || !use(first, data))
        {
          error = "section " + std::to_string(first) + " " + error;
          return false;
        }
        data += Align(sections[first].StoredSize);
      }
    }
    return true;
  }
};

vtkMTFileSource::vtkMTFileSource()
  : Implementation(new Internals)
{
}

vtkMTFileSource::~vtkMTFileSource() = default;

bool vtkMTFileSource::Open(const std::string& path, std::string& error)
{
  this->Graph = vtkMTGraph();
  this->Implementation = std::make_unique<Internals>();
  std::shared_ptr<const vtkMTByteSource> bytes = vtkMTFileByteSource::Open(path, error);
  return bytes && this->Open(bytes, error);
}

bool vtkMTFileSource::Open(std::shared_ptr<const vtkMTByteSource> bytes, std::string& error)
{
  this->Implementation = std::make_unique<Internals>();
  bool opened = false;
  std::string reason;
  try
  {
    opened = vtkMTFileDag::Decode(*bytes, this->Graph, this->Implementation->Directory, reason);
  }
  catch (const std::bad_alloc&)
  {
    reason = "there is not enough memory for its DAG";
  }
  if (!opened)
  {
    error = bytes->GetName() + ": " + reason;
    this->Graph = vtkMTGraph();
    this->Implementation = std::make_unique<Internals>();
    return false;
  }
  this->Implementation->Bytes = std::move(bytes);
  return true;
}

bool vtkMTFileSource::CanRead(const std::string& path)
{
  std::string error;
  unsigned char begin[8];
  const auto bytes = vtkMTFileByteSource::Open(path, error);
  return bytes && bytes->Read(0, sizeof(begin), begin, error) && vtkMTFileDag::HasMagic(begin, sizeof(begin));
}

bool vtkMTFileSource::ReadPatch(
  std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const
{
  patch = vtkMTPatch();
  const std::size_t arrayCount = this->Graph.Arrays.size();
  if (arc >= this->Graph.Arcs.size() || (arrays && arrays->size() != arrayCount))
  {
    error = this->GetName() + ": a patch or an array was asked for that does not exist";
    return false;
  }
  std::vector<unsigned char> wanted(arrayCount + 1, 1);
  for (std::size_t i = 0; arrays && i < arrayCount; ++i)
  {
    wanted[i + 1] = (*arrays)[i];
  }
  std::vector<vtkMTColumn*> columns(arrayCount);
  std::string reason;
  bool done = false;
  try
  {
    std::size_t counts[2] = { 0, 0 };
    for (const vtkMTArrayInfo& array : this->Graph.Arrays)
    {
      ++counts[array.Association];
    }
    patch.PointColumns.resize(counts[vtkMTArrayInfo::Point]);
    patch.CellColumns.resize(counts[vtkMTArrayInfo::Cell]);
    std::size_t next[2] = { 0, 0 };
    for (std::size_t i = 0; i < arrayCount; ++i)
    {
      const bool ofPoints = this->Graph.Arrays[i].Association == vtkMTArrayInfo::Point;
      columns[i] = ofPoints ? &patch.PointColumns[next[0]++] : &patch.CellColumns[next[1]++];
    }
    const vtkMTArc& record = this->Graph.Arcs[arc];
    const Section* sections = this->Implementation->SectionsOf(arc, arrayCount);
    done = this->Implementation->Read(sections, wanted, reason,
      [&](std::size_t section, const unsigned char* data)
      {
        return section == 0 ? vtkMTPatchCodec::DecodeGeometry(sections[0], data, record, patch, reason)
                            : vtkMTPatchCodec::DecodeColumn(sections[section], data, record,
                                this->Graph.Arrays[section - 1], *columns[section - 1], reason);
      });
  }
  catch (const std::bad_alloc&)
  {
    reason = "there is not enough memory";
  }
  if (!done)
  {
    patch = vtkMTPatch();
    error = this->GetName() + ": patch " + std::to_string(arc) + ": " + reason;
  }
  return done;
}

bool vtkMTFileSource::ReadBlob(std::uint32_t blob, std::vector<unsigned char>& bytes, std::string& error) const
{
  if (blob >= this->Graph.Blobs.size())
  {
    return this->vtkMTPatchSource::ReadBlob(blob, bytes, error);
  }
  bytes.clear();
  const Section& section = *(this->Implementation->Directory.end() -
    static_cast<std::ptrdiff_t>(this->Graph.Blobs.size()) + static_cast<std::ptrdiff_t>(blob));
  std::string reason;
  bool done = false;
  try
  {
    done = this->Implementation->Read(&section, { 1 }, reason,
      [&](std::size_t, const unsigned char* data)
      {
        bytes.assign(data, data + section.StoredSize);
        return true;
      });
  }
  catch (const std::bad_alloc&)
  {
    reason = "there is not enough memory";
  }
  error = done ? error : this->GetName() + ": blob " + std::to_string(blob) + ": " + reason;
  return done;
}

std::uint64_t vtkMTFileSource::GetPatchSize(std::uint32_t arc) const
{
  std::uint64_t size = 0;
  const std::size_t arrayCount = this->Graph.Arrays.size();
  for (std::size_t i = 0; arc < this->Graph.Arcs.size() && i <= arrayCount; ++i)
  {
    size += Align(this->Implementation->SectionsOf(arc, arrayCount)[i].StoredSize);
  }
  return size;
}

std::vector<std::uint64_t> vtkMTFileSource::GetSizeByKind() const
{
  std::vector<std::uint64_t> sizes(this->Graph.Arrays.size() + 1, 0);
  const std::size_t sections = this->Graph.Arcs.size() * sizes.size();
  for (std::size_t i = 0; i < sections; ++i)
  {
    sizes[i % sizes.size()] += Align(this->Implementation->Directory[i].StoredSize);
  }
  return sizes;
}

std::string vtkMTFileSource::GetName() const
{
  return this->Implementation->Bytes ? this->Implementation->Bytes->GetName() : "no file";
}

std::uint64_t vtkMTFileSource::GetFileSize() const
{
  return this->Implementation->Bytes ? this->Implementation->Bytes->GetSize() : 0;
}
