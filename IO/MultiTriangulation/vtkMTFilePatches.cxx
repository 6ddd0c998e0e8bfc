// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFilePatches.h"

#include "vtkMTByteSource.h"
#include "vtkMTDecodeScratch.h"
#include "vtkMTFileSource.h"
#include "vtkMTPatchCodec.h"

#include <algorithm>
#include <new>

using vtkMTFileFormat::Align;

namespace
{
// What a patch is decoded with is kept for the next one by each thread, unless it was an uncommonly large one.
class ScratchOfThread
{
public:
  explicit ScratchOfThread(const vtkMTArc& arc)
    : IsLarge(arc.Triangles > LargeSize || arc.Wedges > LargeSize)
  {
  }
  ~ScratchOfThread()
  {
    if (this->IsLarge || Get().Stored.size() > LargeBytes || Get().Bytes.size() > LargeBytes)
    {
      Get() = vtkMTDecodeScratch();
    }
  }
  ScratchOfThread(const ScratchOfThread&) = delete;
  ScratchOfThread& operator=(const ScratchOfThread&) = delete;

  static vtkMTDecodeScratch& Get()
  {
    thread_local vtkMTDecodeScratch scratch;
    return scratch;
  }

private:
  static constexpr std::uint32_t LargeSize = 8192; // two megabytes or so
  static constexpr std::size_t LargeBytes = 1 << 20;
  bool IsLarge;
};
}

//------------------------------------------------------------------------------
bool vtkMTFilePatches::IsWanted(const vtkMTFileSection& section, const std::vector<unsigned char>* arrays)
{
  return section.IsGeometry() || (section.IsArray() && (!arrays || (*arrays)[section.GetArray()] != 0));
}

//------------------------------------------------------------------------------
bool vtkMTFilePatches::Extend(Run& run, std::uint32_t arc, const std::vector<unsigned char>* arrays) const
{
  Run longer = run;
  for (const vtkMTFileSection& section : this->Tables.GetSections(arc))
  {
    if (!IsWanted(section, arrays))
    {
      continue;
    }
    longer.Begin = longer.End == 0 ? section.Offset : longer.Begin;
    if (longer.End != 0 && (section.Offset < longer.End || section.Offset - longer.End > vtkMTFileSource::MaximumGap))
    {
      return false;
    }
    longer.End = section.GetEnd();
  }
  if (longer.End - longer.Begin > vtkMTFileSource::MaximumRead)
  {
    return false;
  }
  run = longer;
  return true;
}

//------------------------------------------------------------------------------
vtkMTColumn& vtkMTFilePatches::GetColumn(std::size_t array, vtkMTPatch& patch) const
{
  const std::vector<vtkMTArrayInfo>& arrays = this->Graph.Arrays;
  const auto association = arrays[array].Association;
  const auto before = std::count_if(arrays.begin(), arrays.begin() + static_cast<std::ptrdiff_t>(array),
    [association](const vtkMTArrayInfo& other) { return other.Association == association; });
  return (
    association == vtkMTArrayInfo::Point ? patch.PointColumns : patch.CellColumns)[static_cast<std::size_t>(before)];
}

//------------------------------------------------------------------------------
bool vtkMTFilePatches::DecodeSection(std::uint32_t arc, const vtkMTFileSection& section, const unsigned char* data,
  vtkMTPatch& patch, std::string& error) const
{
  const vtkMTArc& record = this->Graph.Arcs[arc];
  bool good = vtkMTPatchCodec::Check(section, data, error);
  if (good && section.IsGeometry())
  {
    good = vtkMTPatchCodec::DecodeGeometry(section, data, record, ScratchOfThread::Get(), patch, error);
  }
  else if (good)
  {
    const std::size_t array = section.GetArray();
    good = vtkMTPatchCodec::DecodeColumn(section, data, record, this->Graph.Arrays[array], patch,
      ScratchOfThread::Get(), this->GetColumn(array, patch), error);
  }
  error = good ? error : "section of class " + std::to_string(section.Class) + " " + error;
  return good;
}

//------------------------------------------------------------------------------
// Neighbours together.
bool vtkMTFilePatches::ReadSections(
  std::uint32_t arc, const std::vector<vtkMTFileSection>& sections, vtkMTPatch& patch, std::string& error) const
{
  std::vector<unsigned char>& buffer = ScratchOfThread::Get().Stored;
  for (std::size_t first = 0; first < sections.size();)
  {
    std::size_t end = first + 1;
    while (end < sections.size() && sections[end].Offset == sections[end - 1].GetEnd())
    {
      ++end;
    }
    const std::uint64_t begin = sections[first].Offset;
    const auto size = static_cast<std::size_t>(sections[end - 1].GetEnd() - begin);
    if (buffer.size() < size + vtkMTPatchCodec::Slack)
    {
      buffer.resize(size + vtkMTPatchCodec::Slack);
    }
    if (!this->Source.Read(begin, size, buffer.data(), error))
    {
      return false;
    }
    for (; first < end; ++first)
    {
      if (!this->DecodeSection(arc, sections[first], buffer.data() + (sections[first].Offset - begin), patch, error))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTFilePatches::Decode(std::uint32_t arc, const std::vector<unsigned char>* arrays, const unsigned char* bytes,
  std::uint64_t begin, vtkMTPatch& patch, std::string& error) const
{
  const vtkMTArc& record = this->Graph.Arcs[arc];
  const ScratchOfThread scratch(record);
  std::vector<vtkMTFileSection> sections = this->Tables.GetSections(arc);
  std::vector<unsigned char> present(this->Graph.Arrays.size(), 0);
  for (const vtkMTFileSection& section : sections)
  {
    if (section.IsArray())
    {
      present[section.GetArray()] = 1;
    }
  }
  for (std::size_t i = 0; i < present.size(); ++i)
  {
    if (!present[i] && (!arrays || (*arrays)[i]) &&
      !vtkMTPatchCodec::MayBeMissing(this->Graph, arc, this->Graph.Arrays[i]))
    {
      error = "has no section for the array \"" + this->Graph.Arrays[i].Name + "\"";
      return false;
    }
  }
  sections.erase(std::remove_if(sections.begin(), sections.end(),
                   [arrays](const vtkMTFileSection& section) { return !IsWanted(section, arrays); }),
    sections.end());
  patch.Kind = record.Kind;
  if (!bytes)
  {
    return this->ReadSections(arc, sections, patch, error);
  }
  return std::all_of(sections.begin(), sections.end(),
    [&](const vtkMTFileSection& section)
    { return this->DecodeSection(arc, section, bytes + (section.Offset - begin), patch, error); });
}

//------------------------------------------------------------------------------
bool vtkMTFilePatches::Read(std::uint32_t arc, const std::vector<unsigned char>* arrays, const unsigned char* bytes,
  std::uint64_t begin, vtkMTPatch& patch, std::string& error) const
{
  patch = vtkMTPatch();
  if (arc >= this->Graph.GetNumberOfKnownArcs() || (arrays && arrays->size() != this->Graph.Arrays.size()))
  {
    error = this->Source.GetName() + ": a patch or an array was asked for that does not exist or is not known yet";
    return false;
  }
  std::string reason;
  bool done = false;
  try
  {
    const auto cells = static_cast<std::size_t>(std::count_if(this->Graph.Arrays.begin(), this->Graph.Arrays.end(),
      [](const vtkMTArrayInfo& array) { return array.Association == vtkMTArrayInfo::Cell; }));
    patch.CellColumns.resize(cells);
    patch.PointColumns.resize(this->Graph.Arrays.size() - cells);
    done = this->Decode(arc, arrays, bytes, begin, patch, reason);
  }
  catch (const std::bad_alloc&)
  {
    reason = "there is not enough memory";
  }
  if (!done)
  {
    patch = vtkMTPatch();
    error = this->Source.GetName() + ": patch " + std::to_string(arc) + ": " + reason;
  }
  return done;
}

//------------------------------------------------------------------------------
bool vtkMTFilePatches::ReadBlob(std::uint32_t blob, std::vector<unsigned char>& bytes, std::string& error) const
{
  const vtkMTFileSection section = this->Tables.GetBlob(blob);
  bytes.clear();
  std::string reason;
  bool done = false;
  try
  {
    // The size is not believed before it has been compared with the file's.
    const std::uint64_t size = Align(section.StoredSize);
    if (section.Offset > this->Source.GetSize() || size > this->Source.GetSize() - section.Offset)
    {
      reason = "it passes the end of the file";
    }
    else
    {
      bytes.resize(static_cast<std::size_t>(size));
      done = this->Source.Read(section.Offset, bytes.size(), bytes.data(), reason) &&
        vtkMTPatchCodec::Check(section, bytes.data(), reason);
    }
  }
  catch (const std::bad_alloc&)
  {
    reason = "there is not enough memory";
  }
  bytes.resize(done ? section.StoredSize : 0);
  error = done ? error : this->Source.GetName() + ": blob " + std::to_string(blob) + ": " + reason;
  return done;
}
