// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileSource.h"

#include "vtkMTFileBlocks.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTFileDagReader.h"
#include "vtkMTFilePatches.h"
#include "vtkMTPatchCodec.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <new>
#include <thread>

struct vtkMTFileSource::Internals
{
  std::shared_ptr<const vtkMTByteSource> Bytes; // null: nothing is open
  vtkMTGraph Graph;
  vtkMTFileTables Tables;

  std::mutex Mutex; // of the reader and what follows
  std::unique_ptr<vtkMTFileDagReader> Reader;
  std::string Failure; // written once, before HasFailed
  std::atomic<bool> HasFailed{ false };
  std::atomic<std::uint64_t> GraphBytesRead{ 0 };

  std::atomic<bool> Stop{ false };
  std::thread Thread;

  ~Internals()
  {
    this->Stop = true;
    if (this->Thread.joinable())
    {
      this->Thread.join();
    }
  }

  vtkMTFilePatches GetPatches() const { return { *this->Bytes, this->Graph, this->Tables }; }

  bool Open(std::shared_ptr<const vtkMTByteSource> bytes, std::string& error)
  {
    std::string reason;
    try
    {
      this->Reader = std::make_unique<vtkMTFileDagReader>(*bytes, this->Graph, this->Tables);
      if (this->Reader->Open(reason))
      {
        this->GraphBytesRead = this->Reader->GetBytesRead();
        this->Bytes = std::move(bytes);
        return true;
      }
    }
    catch (const std::bad_alloc&)
    {
      reason = "there is not enough memory for its graph";
    }
    error = bytes->GetName() + ": " + reason;
    return false;
  }

  bool ReadOn(std::uint64_t count, std::string& error)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->Failure.empty() || !this->Reader || this->Reader->IsWhole())
    {
      error = this->Failure;
      return this->Failure.empty();
    }
    std::string reason;
    bool done = false;
    try
    {
      done = this->Reader->ReadOn(count, reason);
    }
    catch (const std::bad_alloc&)
    {
      reason = "there is not enough memory for its graph";
    }
    this->GraphBytesRead = this->Reader->GetBytesRead();
    if (!done)
    {
      this->Failure = this->Bytes->GetName() + ": " + reason;
      this->HasFailed = true;
      error = this->Failure;
    }
    return done;
  }

  void ReadAll()
  {
    constexpr std::uint64_t atOnce = std::uint64_t(1) << 20;
    std::string error;
    while (!this->Stop && !this->Graph.IsWhole() && this->ReadOn(atOnce, error))
    {
    }
  }
};

vtkMTFileSource::vtkMTFileSource()
  : Implementation(new Internals)
{
}

vtkMTFileSource::~vtkMTFileSource() = default;

bool vtkMTFileSource::Open(const std::string& path, std::string& error)
{
  this->Implementation = std::make_unique<Internals>();
  std::shared_ptr<const vtkMTByteSource> bytes = vtkMTFileByteSource::Open(path, error);
  return bytes && this->Open(bytes, error);
}

bool vtkMTFileSource::Open(std::shared_ptr<const vtkMTByteSource> bytes, std::string& error)
{
  if (!this->OpenFirstPages(std::move(bytes), error))
  {
    return false;
  }
  if (!this->Implementation->ReadOn(std::numeric_limits<std::uint64_t>::max(), error))
  {
    this->Implementation = std::make_unique<Internals>();
    return false;
  }
  this->Implementation->Reader.reset();
  return true;
}

bool vtkMTFileSource::OpenFirstPages(const std::string& path, std::string& error)
{
  this->Implementation = std::make_unique<Internals>();
  std::shared_ptr<const vtkMTByteSource> bytes = vtkMTFileByteSource::Open(path, error);
  return bytes && this->OpenFirstPages(bytes, error);
}

bool vtkMTFileSource::OpenFirstPages(std::shared_ptr<const vtkMTByteSource> bytes, std::string& error)
{
  this->Implementation = std::make_unique<Internals>();
  if (!this->Implementation->Open(std::move(bytes), error))
  {
    this->Implementation = std::make_unique<Internals>();
    return false;
  }
  return true;
}

bool vtkMTFileSource::ReadOn(std::uint64_t bytes, std::string& error) const
{
  return this->Implementation->ReadOn(bytes, error);
}

void vtkMTFileSource::StartReadingOn()
{
  Internals& own = *this->Implementation;
  if (!own.Thread.joinable() && !own.Graph.IsWhole())
  {
    own.Thread = std::thread([&own] { own.ReadAll(); });
  }
}

std::uint64_t vtkMTFileSource::GetGraphBytesRead() const
{
  return this->Implementation->GraphBytesRead;
}

const vtkMTGraph& vtkMTFileSource::GetGraph() const
{
  if (!this->Implementation->Graph.IsWhole())
  {
    std::string error; // is kept, and the graph tells that it is not whole
    this->Implementation->ReadOn(std::numeric_limits<std::uint64_t>::max(), error);
  }
  return this->Implementation->Graph;
}

const vtkMTGraph& vtkMTFileSource::GetKnownGraph() const
{
  return this->Implementation->Graph;
}

std::string vtkMTFileSource::GetGraphError() const
{
  return this->Implementation->HasFailed ? this->Implementation->Failure : std::string();
}

bool vtkMTFileSource::CanRead(const std::string& path)
{
  std::string error;
  unsigned char begin[8];
  const auto bytes = vtkMTFileByteSource::Open(path, error);
  return bytes && bytes->Read(0, sizeof(begin), begin, error) && vtkMTFileBlocks::HasMagic(begin, sizeof(begin));
}

bool vtkMTFileSource::ReadPatch(
  std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const
{
  if (!this->Implementation->Bytes)
  {
    patch = vtkMTPatch();
    error = "no file is open";
    return false;
  }
  return this->Implementation->GetPatches().Read(arc, arrays, nullptr, 0, patch, error);
}

void vtkMTFileSource::ReadPatches(
  const std::vector<std::uint32_t>& arcs, const std::vector<unsigned char>* arrays, const PatchUse& use) const
{
  const Internals& self = *this->Implementation;
  if (!self.Bytes || (arrays && arrays->size() != self.Graph.Arrays.size()))
  {
    this->vtkMTPatchSource::ReadPatches(arcs, arrays, use); // which says so of each
    return;
  }
  const vtkMTFilePatches patches = self.GetPatches();
  std::vector<unsigned char> buffer;
  for (std::size_t first = 0; first < arcs.size();)
  {
    // As many whole patches as one read may bring.
    vtkMTFilePatches::Run run;
    std::size_t end = first;
    while (end < arcs.size() && arcs[end] < self.Graph.GetNumberOfKnownArcs() && patches.Extend(run, arcs[end], arrays))
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
      const bool good = patches.Read(arcs[first], arrays, bytes, run.Begin, patch, error);
      use(first, good, patch, error);
    }
  }
}

std::uint64_t vtkMTFileSource::GetPatchPlace(std::uint32_t arc) const
{
  return arc < this->Implementation->Graph.GetNumberOfKnownArcs() ? this->Implementation->Tables.Patches[arc].Offset
                                                                  : this->vtkMTPatchSource::GetPatchPlace(arc);
}

bool vtkMTFileSource::ReadBlob(std::uint32_t blob, std::vector<unsigned char>& bytes, std::string& error) const
{
  return blob < this->Implementation->Graph.Blobs.size() && this->Implementation->Bytes
    ? this->Implementation->GetPatches().ReadBlob(blob, bytes, error)
    : this->vtkMTPatchSource::ReadBlob(blob, bytes, error);
}

std::uint64_t vtkMTFileSource::GetPatchSize(std::uint32_t arc) const
{
  std::uint64_t size = 0;
  if (arc < this->Implementation->Graph.GetNumberOfKnownArcs())
  {
    for (const vtkMTFileSection& section : this->Implementation->Tables.GetSections(arc))
    {
      size += section.GetEnd() - section.Offset;
    }
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
  const vtkMTGraph& graph = this->Implementation->Graph;
  if (arc >= graph.GetNumberOfKnownArcs())
  {
    return 0;
  }
  const vtkMTArc& record = graph.Arcs[arc];
  std::uint64_t size =
    bytesPerTriangle * std::uint64_t(record.Triangles) + bytesPerWedge * std::uint64_t(record.Wedges);
  for (const vtkMTArrayInfo& array : graph.Arrays)
  {
    const std::uint64_t tuples = array.Association == vtkMTArrayInfo::Point ? record.Wedges : record.Triangles;
    size = std::max(size, tuples * (array.GetTupleSize() + bytesPerTuple));
  }
  return size;
}

std::vector<std::uint64_t> vtkMTFileSource::GetSizeByKind() const
{
  const vtkMTGraph& graph = this->GetGraph();
  std::vector<std::uint64_t> sizes(graph.Arrays.size() + 1, 0);
  for (std::uint32_t arc = 0; arc < graph.GetNumberOfKnownArcs(); ++arc)
  {
    for (const vtkMTFileSection& section : this->Implementation->Tables.GetSections(arc))
    {
      if (section.IsGeometry() || section.IsArray())
      {
        sizes[section.IsGeometry() ? 0 : section.GetArray() + 1] += section.GetEnd() - section.Offset;
      }
    }
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
