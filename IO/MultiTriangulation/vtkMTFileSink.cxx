// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileSink.h"

#include "vtkMTBytes.h"
#include "vtkMTChecksum.h"
#include "vtkMTFileDag.h"
#include "vtkMTFileSpoolStore.h"
#include "vtkMTGraph.h"
#include "vtkMTOutputFile.h"
#include "vtkMTPatchCodec.h"
#include "vtkMTRelease.h"

#include <array>
#include <limits>
#include <new>

using vtkMTFileFormat::Align;
using vtkMTFileFormat::Section;
using vtkMTFileFormat::SectionRecord;

namespace
{
// In a store.
const std::string SpoolName = "model-patches";
const std::string TablesName = "model-tables";

struct EncodedPatch : public vtkMTPatchSink::PreparedPatch
{
  std::vector<unsigned char> Bytes;
  std::vector<Section> Sections; // offsets from the patch's first byte
  std::array<std::uint32_t, 4> Counts;
};
}

struct vtkMTFileSink::Internals
{
  std::string Path;
  std::vector<vtkMTArrayInfo> Arrays;
  vtkMTSpoolStore* Store = nullptr;
  std::unique_ptr<vtkMTSpool> Spool;  // null: not begun
  std::unique_ptr<vtkMTSpool> Tables; // what Save has put aside of Sections and Counts
  std::size_t SavedPatches = 0;
  vtkMTFileFormat::Codec Codec = vtkMTFileFormat::Lz4;
  std::vector<Section> Sections;                    // of the patches in the order of writing; offsets in the spool
  std::vector<Section> Blobs;                       // the same
  std::vector<std::array<std::uint32_t, 4>> Counts; // points, wedges, triangles, shared points of each patch
  std::vector<unsigned char> Bytes;                 // of what is copied
  std::uint64_t FileSize = 0;

  std::size_t SectionsPerPatch() const { return this->Arrays.size() + 1; }

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
    this->Sections = {};
    this->Blobs = {};
    this->Counts = {};
    this->Bytes = {};
  }

  bool Append(const EncodedPatch& patch, std::string& error)
  {
    const std::uint64_t begin = this->Spool->GetSize();
    if (!this->AppendBytes(patch.Bytes, error))
    {
      return false;
    }
    for (Section section : patch.Sections)
    {
      section.Offset += begin;
      this->Sections.push_back(section);
    }
    this->Counts.push_back(patch.Counts);
    return true;
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
    Section section{};
    if (bytes.size() > std::numeric_limits<std::uint32_t>::max())
    {
      error = this->Path + ": a blob has more than 4 GiB";
      return false;
    }
    section.Offset = this->Spool->GetSize();
    section.StoredSize = static_cast<std::uint32_t>(bytes.size());
    section.Codec = vtkMTFileFormat::Raw;
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
      error = "the graph's arrays are not those that were announced";
      return false;
    }
    if (this->Blobs.size() != graph.Blobs.size())
    {
      error = std::to_string(this->Blobs.size()) + " blobs were written where " + std::to_string(graph.Blobs.size()) +
        " are described";
      return false;
    }
    std::vector<bool> used(this->Counts.size());
    for (std::size_t arc = 0; arc < patchOfArc.size() && arc < graph.Arcs.size(); ++arc)
    {
      const std::uint32_t patch = patchOfArc[arc];
      const vtkMTArc& record = graph.Arcs[arc];
      if (patch >= used.size() || used[patch] ||
        this->Counts[patch] !=
          std::array<std::uint32_t, 4>{ record.Points, record.Wedges, record.Triangles, record.SharedPoints })
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

  std::vector<SectionRecord> MakeDirectory(const std::vector<std::uint32_t>& patchOfArc) const
  {
    std::vector<SectionRecord> directory;
    directory.reserve(this->Sections.size());
    for (const std::uint32_t patch : patchOfArc)
    {
      const auto first = this->Sections.begin() + static_cast<std::ptrdiff_t>(patch * this->SectionsPerPatch());
      directory.insert(directory.end(), first, first + static_cast<std::ptrdiff_t>(this->SectionsPerPatch()));
    }
    directory.insert(directory.end(), this->Blobs.begin(), this->Blobs.end());
    return directory;
  }

  // A disk may give back other bytes than it was given: what goes into the file is checked on the way.
  bool Copy(const Section* sections, std::size_t count, vtkMTOutputFile& output, std::string& error)
  {
    const Section& last = sections[count - 1];
    this->Bytes.resize(static_cast<std::size_t>(last.Offset + Align(last.StoredSize) - sections[0].Offset));
    if (!this->Spool->Read(sections[0].Offset, this->Bytes.size(), this->Bytes.data(), error))
    {
      return false;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!vtkMTPatchCodec::Check(sections[i], this->Bytes.data() + (sections[i].Offset - sections[0].Offset), error))
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
    vtkMTFileDag::Encode(graph, this->MakeDirectory(patchOfArc), head);
    vtkMTOutputFile output;
    if (!output.Open(this->Path) || !output.Write(head.data(), head.size()))
    {
      error = output.GetError();
      return false;
    }
    vtkMTRelease(head);
    for (const std::uint32_t patch : patchOfArc)
    {
      if (!this->Copy(&this->Sections[patch * this->SectionsPerPatch()], this->SectionsPerPatch(), output, error))
      {
        return false;
      }
    }
    for (const Section& blob : this->Blobs)
    {
      if (!this->Copy(&blob, 1, output, error))
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
  auto encoded = std::make_unique<EncodedPatch>();
  std::string reason;
  if (!vtkMTPatchCodec::Encode(patch, own.Arrays, own.Codec, encoded->Bytes, encoded->Sections, reason))
  {
    error = own.Path + ": a patch " + reason;
    return nullptr;
  }
  encoded->Counts = { static_cast<std::uint32_t>(patch.Points.size()),
    static_cast<std::uint32_t>(patch.GetNumberOfWedges()), static_cast<std::uint32_t>(patch.Triangles.size()),
    static_cast<std::uint32_t>(patch.Ids.size()) };
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
  if (patch && own.Append(static_cast<const EncodedPatch&>(*patch), this->Error))
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
  // What is new since the last time, patch by patch.
  std::vector<unsigned char> fresh;
  vtkMTBytes::Writer table(fresh);
  for (std::size_t patch = own.SavedPatches; patch < own.Counts.size(); ++patch)
  {
    table.Put(own.Counts[patch]);
    for (std::size_t i = 0; i < own.SectionsPerPatch(); ++i)
    {
      table.Put(own.Sections[patch * own.SectionsPerPatch() + i]);
    }
  }
  if (!own.Tables->Append(fresh.data(), fresh.size(), this->Error))
  {
    return false;
  }
  own.SavedPatches = own.Counts.size();
  state.clear();
  vtkMTBytes::Writer writer(state);
  writer.Put<std::uint32_t>(own.Codec);
  writer.Put(own.Spool->GetSize());
  writer.Put<std::uint64_t>(own.SavedPatches);
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
  reader.TakeList(own.Blobs);
  own.Arrays = arrays;
  this->Error.clear();
  if (!own.Store || !reader.IsSound() || codec != static_cast<std::uint32_t>(own.Codec))
  {
    this->Error = own.Path + ": was begun with another compression, or its state is damaged";
    return false;
  }
  const std::size_t row = sizeof(own.Counts[0]) + own.SectionsPerPatch() * sizeof(Section);
  std::vector<unsigned char> bytes(static_cast<std::size_t>(patches) * row);
  own.Spool = own.Store->Open(SpoolName, size, this->Error);
  own.Tables = own.Spool ? own.Store->Open(TablesName, bytes.size(), this->Error) : nullptr;
  if (!own.Tables || !own.Tables->Read(0, bytes.size(), bytes.data(), this->Error))
  {
    return false;
  }
  vtkMTBytes::Reader table(bytes);
  for (own.SavedPatches = 0; own.SavedPatches < patches; ++own.SavedPatches)
  {
    own.Counts.push_back(table.Take<std::array<std::uint32_t, 4>>());
    for (std::size_t i = 0; i < own.SectionsPerPatch(); ++i)
    {
      own.Sections.push_back(table.Take<Section>());
    }
  }
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
