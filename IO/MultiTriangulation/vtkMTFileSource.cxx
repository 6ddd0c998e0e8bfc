// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileSource.h"

#include "vtkMTDecodeScratch.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTFileDag.h"
#include "vtkMTPatchCodec.h"

#include <algorithm>
#include <new>

using vtkMTFileFormat::Align;
using vtkMTFileFormat::Section;

namespace
{
// What a patch is decoded with is kept for the next one by each thread, unless it was an uncommonly large one.
class TraversalOfThread
{
public:
  explicit TraversalOfThread(const vtkMTArc& arc)
    : IsLarge(arc.Triangles > LargeSize || arc.Wedges > LargeSize)
  {
  }
  ~TraversalOfThread()
  {
    if (this->IsLarge || Get().Stored.size() > LargeBytes || Get().Bytes.size() > LargeBytes)
    {
      Get() = vtkMTDecodeScratch();
    }
  }
  TraversalOfThread(const TraversalOfThread&) = delete;
  TraversalOfThread& operator=(const TraversalOfThread&) = delete;

  static vtkMTDecodeScratch& Get()
  {
    thread_local vtkMTDecodeScratch traversal;
    return traversal;
  }

private:
  static constexpr std::uint32_t LargeSize = 8192; // two megabytes or so
  static constexpr std::size_t LargeBytes = 1 << 20;
  bool IsLarge;
};
}

struct vtkMTFileSource::Internals
{
  std::shared_ptr<const vtkMTByteSource> Bytes;
  std::vector<Section> Directory;

  const Section* SectionsOf(std::uint32_t arc, std::size_t arrays) const
  {
    return this->Directory.data() + std::size_t(arc) * (arrays + 1);
  }

  // A range of bytes that holds the wanted sections of some patches.
  struct Run
  {
    std::uint64_t Begin = 0;
    std::uint64_t End = 0;
  };

  // Takes the wanted sections of a patch into the range; false, and nothing done, when the range would become too long
  // or would have too wide a gap.
  bool Extend(Run& run, std::uint32_t arc, const std::vector<unsigned char>* arrays, const vtkMTGraph& graph) const
  {
    const Section* sections = this->SectionsOf(arc, graph.Arrays.size());
    Run longer = run;
    for (std::size_t i = 0; i <= graph.Arrays.size(); ++i)
    {
      if (i > 0 && arrays && (i > arrays->size() || !(*arrays)[i - 1]))
      {
        continue;
      }
      const std::uint64_t begin = sections[i].Offset;
      longer.Begin = longer.End == 0 ? begin : longer.Begin;
      if (longer.End != 0 && (begin < longer.End || begin - longer.End > vtkMTFileSource::MaximumGap))
      {
        return false;
      }
      longer.End = begin + Align(sections[i].StoredSize);
    }
    if (longer.End - longer.Begin > vtkMTFileSource::MaximumRead)
    {
      return false;
    }
    run = longer;
    return true;
  }

  // Reads the wanted sections of a patch, neighbours together, and hands each one to use(index, its bytes). buffer only
  // grows.
  template <typename Use>
  bool Read(const Section* sections, const std::vector<unsigned char>& wanted, std::vector<unsigned char>& buffer,
    std::string& error, Use&& use) const
  {
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
      if (buffer.size() < size + vtkMTPatchCodec::Slack)
      {
        buffer.resize(size + vtkMTPatchCodec::Slack);
      }
      if (!this->Bytes->Read(sections[first].Offset, size, buffer.data(), error))
      {
        return false;
      }
      const unsigned char* data = buffer.data();
      for (; first < end; ++first)
      {
        if (!use(first, data))
        {
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

// Empties the patch, gives it a column for each array, and says which sections are wanted.
bool vtkMTFileSource::PreparePatch(std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch,
  std::vector<unsigned char>& wanted, std::string& error) const
{
  patch = vtkMTPatch();
  const std::size_t arrayCount = this->Graph.Arrays.size();
  if (arc >= this->Graph.Arcs.size() || (arrays && arrays->size() != arrayCount))
  {
    error = this->GetName() + ": a patch or an array was asked for that does not exist";
    return false;
  }
  wanted.assign(arrayCount + 1, 1);
  std::size_t counts[2] = { 0, 0 };
  for (std::size_t i = 0; i < arrayCount; ++i)
  {
    wanted[i + 1] = arrays ? (*arrays)[i] : 1;
    ++counts[this->Graph.Arrays[i].Association];
  }
  patch.PointColumns.resize(counts[vtkMTArrayInfo::Point]);
  patch.CellColumns.resize(counts[vtkMTArrayInfo::Cell]);
  return true;
}

bool vtkMTFileSource::DecodeSection(
  std::uint32_t arc, std::size_t section, const unsigned char* data, vtkMTPatch& patch, std::string& error) const
{
  const vtkMTArc& record = this->Graph.Arcs[arc];
  const Section& place = this->Implementation->SectionsOf(arc, this->Graph.Arrays.size())[section];
  bool good = vtkMTPatchCodec::Check(place, data, error);
  if (good && section == 0)
  {
    good = vtkMTPatchCodec::DecodeGeometry(place, data, record, TraversalOfThread::Get(), patch, error);
  }
  else if (good)
  {
    const vtkMTArrayInfo& array = this->Graph.Arrays[section - 1];
    const auto before =
      std::count_if(this->Graph.Arrays.begin(), this->Graph.Arrays.begin() + static_cast<std::ptrdiff_t>(section - 1),
        [&array](const vtkMTArrayInfo& other) { return other.Association == array.Association; });
    auto& columns = array.Association == vtkMTArrayInfo::Point ? patch.PointColumns : patch.CellColumns;
    good = vtkMTPatchCodec::DecodeColumn(
      place, data, record, array, TraversalOfThread::Get(), columns[static_cast<std::size_t>(before)], error);
  }
  error = good ? error : "section " + std::to_string(section) + " " + error;
  return good;
}

bool vtkMTFileSource::ReadPatch(
  std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const
{
  std::string reason;
  bool done = false;
  try
  {
    std::vector<unsigned char> wanted;
    if (!this->PreparePatch(arc, arrays, patch, wanted, error))
    {
      return false;
    }
    const TraversalOfThread traversal(this->Graph.Arcs[arc]);
    done = this->Implementation->Read(this->Implementation->SectionsOf(arc, this->Graph.Arrays.size()), wanted,
      TraversalOfThread::Get().Stored, reason,
      [&](std::size_t section, const unsigned char* data)
      { return this->DecodeSection(arc, section, data, patch, reason); });
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

void vtkMTFileSource::ReadPatches(
  const std::vector<std::uint32_t>& arcs, const std::vector<unsigned char>* arrays, const PatchUse& use) const
{
  const Internals& self = *this->Implementation;
  std::vector<unsigned char> buffer;
  for (std::size_t first = 0; first < arcs.size();)
  {
    // As many whole patches as one read may bring.
    Internals::Run run;
    std::size_t end = first;
    while (end < arcs.size() && arcs[end] < this->Graph.Arcs.size() && self.Extend(run, arcs[end], arrays, this->Graph))
    {
      ++end;
    }
    bool read = end > first + 1;
    try
    {
      std::string error;
      const std::size_t size = read ? static_cast<std::size_t>(run.End - run.Begin) : 0;
      buffer.resize(size + vtkMTPatchCodec::Slack);
      read = read && self.Bytes->Read(run.Begin, size, buffer.data(), error);
    }
    catch (const std::bad_alloc&)
    {
      read = false;
    }
    // One patch alone, or a run that cannot be read as a whole: patch by patch.
    const unsigned char* bytes = read ? buffer.data() : nullptr;
    for (end = std::max(end, first + 1); first < end; ++first)
    {
      vtkMTPatch patch;
      std::string error;
      const bool good = bytes ? this->TakePatch(arcs[first], arrays, bytes, run.Begin, patch, error)
                              : this->ReadPatch(arcs[first], arrays, patch, error);
      use(first, good, patch, error);
    }
  }
}

// A patch out of bytes that were read for several.
bool vtkMTFileSource::TakePatch(std::uint32_t arc, const std::vector<unsigned char>* arrays, const unsigned char* bytes,
  std::uint64_t begin, vtkMTPatch& patch, std::string& error) const
{
  std::string reason;
  bool done = false;
  try
  {
    std::vector<unsigned char> wanted;
    if (!this->PreparePatch(arc, arrays, patch, wanted, error))
    {
      return false;
    }
    const Section* sections = this->Implementation->SectionsOf(arc, this->Graph.Arrays.size());
    const TraversalOfThread traversal(this->Graph.Arcs[arc]);
    done = true;
    for (std::size_t i = 0; done && i < wanted.size(); ++i)
    {
      done = !wanted[i] || this->DecodeSection(arc, i, bytes + (sections[i].Offset - begin), patch, reason);
    }
  }
  catch (const std::bad_alloc&)
  {
    done = false;
    reason = "there is not enough memory";
  }
  if (!done)
  {
    patch = vtkMTPatch();
    error = this->GetName() + ": patch " + std::to_string(arc) + ": " + reason;
  }
  return done;
}

std::uint64_t vtkMTFileSource::GetPatchPlace(std::uint32_t arc) const
{
  return arc < this->Graph.Arcs.size() ? this->Implementation->SectionsOf(arc, this->Graph.Arrays.size())->Offset
                                       : this->vtkMTPatchSource::GetPatchPlace(arc);
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
    std::vector<unsigned char> buffer;
    done = this->Implementation->Read(&section, { 1 }, buffer, reason,
      [&](std::size_t, const unsigned char* data)
      {
        const bool good = vtkMTPatchCodec::Check(section, data, reason);
        reason = good ? reason : "section 0 " + reason;
        bytes.assign(data, data + (good ? section.StoredSize : 0));
        return good;
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

// What vtkMTPackedGeometry and vtkMTColumnCodec hold while they work: gates on both sides of the
// front and of the border, bases, orders and identities of wedges; then one column's bytes. LoadingFromFile compares it
// with what is allocated.
std::uint64_t vtkMTFileSource::GetDecodeSize(std::uint32_t arc) const
{
  constexpr std::uint64_t bytesPerTriangle = 128;
  constexpr std::uint64_t bytesPerWedge = 128;
  constexpr std::uint64_t bytesPerTuple = 4;
  if (arc >= this->Graph.Arcs.size())
  {
    return 0;
  }
  const vtkMTArc& record = this->Graph.Arcs[arc];
  std::uint64_t size =
    bytesPerTriangle * std::uint64_t(record.Triangles) + bytesPerWedge * std::uint64_t(record.Wedges);
  for (const vtkMTArrayInfo& array : this->Graph.Arrays)
  {
    const std::uint64_t tuples = array.Association == vtkMTArrayInfo::Point ? record.Wedges : record.Triangles;
    size = std::max(size, tuples * (array.GetTupleSize() + bytesPerTuple));
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
