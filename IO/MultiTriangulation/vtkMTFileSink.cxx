// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileSink.h"

#include "vtkMTBytes.h"
#include "vtkMTChecksum.h"
#include "vtkMTFileDag.h"
#include "vtkMTFileSpoolStore.h"
#include "vtkMTGraph.h"
#include "vtkMTOutputFile.h"
#include "vtkMTPatchCodec.h"
#include "vtkMTPatchTable.h"
#include "vtkMTRangeCollector.h"
#include "vtkMTRelease.h"

#include <limits>
#include <new>

using vtkMTFileFormat::Align;

namespace
{
// In a store.
const std::string SpoolName = "model-patches";
const std::string TablesName = "model-tables";
}

struct vtkMTFileSink::Internals
{
  std::string Path;
  std::vector<vtkMTArrayInfo> Arrays;
  vtkMTSpoolStore* Store = nullptr;
  std::unique_ptr<vtkMTSpool> Spool;  // null: not begun
  std::unique_ptr<vtkMTSpool> Tables; // what Save has put aside of Patches
  std::size_t SavedPatches = 0;
  std::uint64_t SavedBytes = 0;
  vtkMTFileFormat::Codec Codec = vtkMTFileFormat::Lz4;
  vtkMTPatchTable Patches;
  std::vector<vtkMTFileSection> Blobs; // offsets in the spool
  std::vector<unsigned char> Bytes;    // of what is copied
  std::uint64_t FileSize = 0;

  void Forget()
  {
    if (this->Store && this->Spool)
    {
      this->Spool.reset();
      this->Tables.reset();
      this->Store->Remove(SpoolName);
      this->Store->Remove(TablesName);
    }
    this->Spool.reset();
    this->SavedPatches = 0;
    this->SavedBytes = 0;
    this->Patches = {};
    this->Blobs = {};
    this->Bytes = {};
  }

  bool Append(const vtkMTEncodedPatch& patch, std::string& error)
  {
    std::string reason;
    const bool done = this->Patches.Append(patch, *this->Spool, reason);
    error = done ? error : this->Path + ": " + reason;
    return done;
  }

  bool AppendBytes(const std::vector<unsigned char>& bytes, std::string& error)
  {
    std::string reason;
    const bool done = this->Spool->Append(bytes.data(), bytes.size(), reason);
    error = done ? error : this->Path + ": " + reason;
    return done;
  }

  bool AppendBlob(std::vector<unsigned char>& bytes, std::string& error)
  {
    vtkMTFileSection section{};
    if (bytes.size() > std::numeric_limits<std::uint32_t>::max())
    {
      error = this->Path + ": a blob has more than 4 GiB";
      return false;
    }
    section.Offset = this->Spool->GetSize();
    section.StoredSize = static_cast<std::uint32_t>(bytes.size());
    section.Codec = vtkMTFileFormat::Raw;
    section.Class = vtkMTFileFormat::BlobClass;
    bytes.resize(static_cast<std::size_t>(Align(bytes.size())), 0);
    section.Checksum = vtkMTChecksum(bytes.data(), bytes.size());
    this->Blobs.push_back(section);
    return this->AppendBytes(bytes, error);
  }

  bool Check(const vtkMTGraph& graph, const std::vector<std::uint32_t>& patchOfArc, std::string& error) const
  {
    if (!vtkMTFileDag::Check(graph, error))
    {
      return false;
    }
    if (!(graph.Arrays == this->Arrays))
    {
      error = "the graph's arrays are not those that were given to Begin";
      return false;
    }
    if (this->Blobs.size() != graph.Blobs.size())
    {
      error = std::to_string(this->Blobs.size()) + " blobs were written where " + std::to_string(graph.Blobs.size()) +
        " are described";
      return false;
    }
    std::vector<bool> used(this->Patches.GetNumberOfPatches());
    for (std::size_t arc = 0; arc < patchOfArc.size() && arc < graph.Arcs.size(); ++arc)
    {
      const std::uint32_t patch = patchOfArc[arc];
      if (patch >= used.size() || used[patch] ||
        !(this->Patches.GetCounts(patch) == vtkMTPatchCounts::Of(graph.Arcs[arc])))
      {
        error = "arc " + std::to_string(arc) + " does not describe the patch that was written for it";
        return false;
      }
      used[patch] = true;
    }
    if (patchOfArc.size() != graph.Arcs.size() || used.size() != graph.Arcs.size())
    {
      error = std::to_string(used.size()) + " patches were written for " + std::to_string(graph.Arcs.size()) + " arcs";
      return false;
    }
    return true;
  }

  // What lies before the patches, and in their order.
  bool MakeContents(const vtkMTGraph& graph, const std::vector<std::uint32_t>& patchOfArc,
    vtkMTFileDag::Contents& contents, std::string& error) const
  {
    vtkMTRangeCollector collector(graph);
    std::vector<vtkMTRange> ranges;
    contents.Sections.assign(this->Blobs.begin(), this->Blobs.end());
    contents.SectionCounts.reserve(patchOfArc.size());
    for (std::uint32_t arc = 0; arc < patchOfArc.size(); ++arc)
    {
      const std::uint32_t patch = patchOfArc[arc];
      const std::vector<vtkMTFileSection> sections = this->Patches.GetSections(patch);
      contents.Sections.insert(contents.Sections.end(), sections.begin(), sections.end());
      contents.SectionCounts.push_back(this->Patches.GetNumberOfSections(patch));
      if (collector.Wants(arc))
      {
        if (!this->Patches.ReadRanges(patch, *this->Spool, ranges, error))
        {
          return false;
        }
        collector.Add(arc, ranges);
      }
    }
    collector.Finish();
    contents.ArrayRanges = collector.GetArrayRanges();
    contents.ArcRanges = collector.GetArcRanges();
    return true;
  }

  // A disk may give back other bytes than it was given: what goes into the file is checked on the way.
  bool Copy(const std::vector<vtkMTFileSection>& sections, vtkMTOutputFile& output, std::string& error)
  {
    if (sections.empty())
    {
      return true;
    }
    this->Bytes.resize(static_cast<std::size_t>(sections.back().GetEnd() - sections[0].Offset));
    if (!this->Spool->Read(sections[0].Offset, this->Bytes.size(), this->Bytes.data(), error))
    {
      return false;
    }
    for (const vtkMTFileSection& section : sections)
    {
      if (!vtkMTPatchCodec::Check(section, this->Bytes.data() + (section.Offset - sections[0].Offset), error))
      {
        error = "the temporary file " + error;
        return false;
      }
    }
    if (!output.Write(this->Bytes.data(), this->Bytes.size()))
    {
      error = output.GetError();
      return false;
    }
    return true;
  }

  bool WriteFile(const vtkMTGraph& graph, const std::vector<std::uint32_t>& patchOfArc, std::string& error)
  {
    std::vector<unsigned char> head;
    vtkMTFileDag::Contents contents;
    if (!this->MakeContents(graph, patchOfArc, contents, error) ||
      !vtkMTFileDag::Encode(graph, contents, head, error))
    {
      error = this->Path + ": " + error;
      return false;
    }
    contents = {};
    vtkMTOutputFile output;
    if (!output.Open(this->Path) || !output.Write(head.data(), head.size()))
    {
      error = output.GetError();
      return false;
    }
    vtkMTRelease(head);
    for (const std::uint32_t patch : patchOfArc)
    {
      if (!this->Copy(this->Patches.GetSections(patch), output, error))
      {
        return false;
      }
    }
    for (const vtkMTFileSection& blob : this->Blobs)
    {
      if (!this->Copy({ blob }, output, error))
      {
        return false;
      }
    }
    this->FileSize = output.GetBytesWritten();
    error = output.Commit() ? "" : output.GetError();
    return error.empty();
  }
};

vtkMTFileSink::vtkMTFileSink(const std::string& path, CompressionType compression, vtkMTSpoolStore* store)
  : Implementation(new Internals)
{
  this->Implementation->Path = path;
  this->Implementation->Store = store;
  this->Implementation->Codec =
    compression == None ? vtkMTFileFormat::Raw : (compression == Fast ? vtkMTFileFormat::Lz4 : vtkMTFileFormat::Zstd);
}

vtkMTFileSink::~vtkMTFileSink() = default;

bool vtkMTFileSink::Begin(const std::vector<vtkMTArrayInfo>& arrays)
{
  Internals& own = *this->Implementation;
  own.Forget();
  own.Arrays = arrays;
  own.FileSize = 0;
  this->Error.clear();
  if (arrays.size() > vtkMTFileFormat::OtherClasses - vtkMTFileFormat::FirstArrayClass)
  {
    this->Error = own.Path + ": " + std::to_string(arrays.size()) + " arrays are more than a file can have";
    return false;
  }
  for (const vtkMTArrayInfo& array : arrays)
  {
    if (array.GetTupleSize() == 0)
    {
      this->Error = own.Path + ": array \"" + array.Name + "\" is of a type that cannot be stored";
      return false;
    }
  }
  // Asked now and not after hours of building: whether the output can be made at all.
  vtkMTOutputFile attempt;
  if (!attempt.Open(own.Path))
  {
    this->Error = attempt.GetError();
    return false;
  }
  std::string reason;
  own.Spool = own.Store ? own.Store->Create(SpoolName, reason) : vtkMTFileSpoolStore::CreateBeside(own.Path, reason);
  own.Tables = own.Spool && own.Store ? own.Store->Create(TablesName, reason) : nullptr;
  this->Error = reason.empty() ? "" : own.Path + ": " + reason;
  return reason.empty();
}

std::unique_ptr<vtkMTPatchSink::PreparedPatch> vtkMTFileSink::Prepare(vtkMTPatch&& patch, std::string& error) const
{
  const Internals& own = *this->Implementation;
  auto encoded = std::make_unique<vtkMTEncodedPatch>();
  std::string reason;
  if (!vtkMTPatchCodec::Encode(patch, own.Arrays, own.Codec, encoded->Bytes, encoded->Sections, reason))
  {
    error = own.Path + ": a patch " + reason;
    return nullptr;
  }
  encoded->Counts = vtkMTPatchCounts::Of(patch);
  encoded->Ranges = patch.GetRanges(own.Arrays);
  patch = vtkMTPatch();
  return encoded;
}

bool vtkMTFileSink::WritePrepared(std::unique_ptr<PreparedPatch> patch)
{
  Internals& own = *this->Implementation;
  if (!own.Spool)
  {
    this->Error = this->Error.empty() ? own.Path + ": a patch was written before Begin" : this->Error;
    return false;
  }
  if (patch && own.Append(static_cast<const vtkMTEncodedPatch&>(*patch), this->Error))
  {
    return true;
  }
  own.Forget();
  return false;
}

bool vtkMTFileSink::WritePatch(vtkMTPatch&& patch)
{
  try
  {
    return this->WritePrepared(this->Implementation->Spool ? this->Prepare(std::move(patch), this->Error) : nullptr);
  }
  catch (const std::bad_alloc&)
  {
    this->Error = this->Implementation->Path + ": there is not enough memory";
  }
  this->Implementation->Forget();
  return false;
}

bool vtkMTFileSink::Save(std::vector<unsigned char>& state)
{
  Internals& own = *this->Implementation;
  if (!own.Tables || !own.Store->IsLasting())
  {
    return false;
  }
  // What is new since the last time.
  std::vector<unsigned char> fresh;
  own.Patches.Save(own.SavedPatches, fresh);
  if (!own.Tables->Append(fresh.data(), fresh.size(), this->Error))
  {
    return false;
  }
  own.SavedPatches = own.Patches.GetNumberOfPatches();
  own.SavedBytes += fresh.size();
  state.clear();
  vtkMTBytes::Writer writer(state);
  writer.Put<std::uint32_t>(own.Codec);
  writer.Put(own.Spool->GetSize());
  writer.Put<std::uint64_t>(own.SavedPatches);
  writer.Put(own.SavedBytes);
  writer.PutList(own.Blobs);
  return true;
}

bool vtkMTFileSink::Restore(const std::vector<vtkMTArrayInfo>& arrays, const std::vector<unsigned char>& state)
{
  Internals& own = *this->Implementation;
  vtkMTBytes::Reader reader(state);
  const auto codec = reader.Take<std::uint32_t>();
  const auto size = reader.Take<std::uint64_t>();
  const auto patches = reader.Take<std::uint64_t>();
  const auto tableBytes = reader.Take<std::uint64_t>();
  reader.TakeList(own.Blobs);
  own.Arrays = arrays;
  this->Error.clear();
  if (!own.Store || !reader.IsSound() || codec != static_cast<std::uint32_t>(own.Codec))
  {
    this->Error = own.Path + ": was begun with another compression, or its state is damaged";
    return false;
  }
  own.Spool = own.Store->Open(SpoolName, size, this->Error);
  own.Tables = own.Spool ? own.Store->Open(TablesName, tableBytes, this->Error) : nullptr;
  std::vector<unsigned char> bytes(own.Tables ? static_cast<std::size_t>(tableBytes) : 0);
  if (!own.Tables || !own.Tables->Read(0, bytes.size(), bytes.data(), this->Error))
  {
    return false;
  }
  if (!own.Patches.Load(patches, bytes))
  {
    this->Error = own.Path + ": the table of its patches is damaged";
    return false;
  }
  own.SavedPatches = static_cast<std::size_t>(patches);
  own.SavedBytes = tableBytes;
  return true;
}

bool vtkMTFileSink::WriteBlob(std::vector<unsigned char>&& bytes)
{
  Internals& own = *this->Implementation;
  if (!own.Spool)
  {
    this->Error = this->Error.empty() ? own.Path + ": a blob was written before Begin" : this->Error;
    return false;
  }
  if (!own.AppendBlob(bytes, this->Error))
  {
    own.Forget();
    return false;
  }
  return true;
}

bool vtkMTFileSink::Finish(const vtkMTGraph& graph, const std::vector<std::uint32_t>& patchOfArc)
{
  Internals& own = *this->Implementation;
  if (!own.Spool)
  {
    this->Error = this->Error.empty() ? own.Path + ": the model was finished before Begin" : this->Error;
    return false;
  }
  bool done = false;
  try
  {
    std::string reason;
    const bool consistent = own.Check(graph, patchOfArc, reason);
    done = consistent && own.WriteFile(graph, patchOfArc, reason);
    this->Error = done ? "" : consistent ? reason : own.Path + ": " + reason;
  }
  catch (const std::bad_alloc&)
  {
    this->Error = own.Path + ": there is not enough memory";
  }
  own.Forget();
  return done;
}

void vtkMTFileSink::Abandon()
{
  this->Implementation->Forget();
}

std::uint64_t vtkMTFileSink::GetFileSize() const
{
  return this->Implementation->FileSize;
}
