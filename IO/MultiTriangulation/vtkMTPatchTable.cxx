// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchTable.h"

#include "vtkMTBytes.h"
#include "vtkMTChecksum.h"
#include "vtkMTSpool.h"

#include <cstring>

using vtkMTFileFormat::SectionRecord;

//------------------------------------------------------------------------------
std::vector<vtkMTFileSection> vtkMTPatchTable::GetSections(std::uint32_t patch) const
{
  const Entry& entry = this->Patches[patch];
  std::vector<vtkMTFileSection> sections(entry.SectionCount);
  std::uint64_t next = entry.Offset;
  for (std::size_t i = 0; i < sections.size(); ++i)
  {
    static_cast<SectionRecord&>(sections[i]) = this->Sections[entry.FirstSection + i];
    sections[i].Offset = next;
    next = sections[i].GetEnd();
  }
  return sections;
}

//------------------------------------------------------------------------------
bool vtkMTPatchTable::Append(const vtkMTEncodedPatch& patch, vtkMTSpool& spool, std::string& error)
{
  const std::size_t size = patch.Ranges.size() * sizeof(vtkMTRange);
  const std::uint64_t checksum = vtkMTChecksum(patch.Ranges.data(), size);
  Entry entry;
  entry.Offset = spool.GetSize();
  entry.FirstSection = static_cast<std::uint32_t>(this->Sections.size());
  entry.SectionCount = static_cast<std::uint16_t>(patch.Sections.size());
  entry.Counts = patch.Counts;
  if (!spool.Append(patch.Bytes.data(), patch.Bytes.size(), error) ||
    (size > 0 &&
      (!spool.Append(patch.Ranges.data(), size, error) || !spool.Append(&checksum, sizeof(checksum), error))))
  {
    return false;
  }
  this->NumberOfRanges = patch.Ranges.size();
  this->Patches.push_back(entry);
  this->Sections.insert(this->Sections.end(), patch.Sections.begin(), patch.Sections.end());
  return true;
}

//------------------------------------------------------------------------------
// A disk may give back other bytes than it was given.
bool vtkMTPatchTable::ReadRanges(
  std::uint32_t patch, const vtkMTSpool& spool, std::vector<vtkMTRange>& ranges, std::string& error) const
{
  const std::size_t size = this->NumberOfRanges * sizeof(vtkMTRange);
  const std::vector<vtkMTFileSection> sections = this->GetSections(patch);
  const std::uint64_t begin = sections.empty() ? this->Patches[patch].Offset : sections.back().GetEnd();
  std::vector<unsigned char> bytes(size + sizeof(std::uint64_t));
  std::uint64_t checksum = 0;
  ranges.resize(this->NumberOfRanges);
  if (size == 0)
  {
    return true;
  }
  if (!spool.Read(begin, bytes.size(), bytes.data(), error))
  {
    return false;
  }
  std::memcpy(static_cast<void*>(ranges.data()), bytes.data(), size);
  std::memcpy(&checksum, bytes.data() + size, sizeof(checksum));
  const bool good = checksum == vtkMTChecksum(bytes.data(), size);
  error = good ? error : "the temporary file is damaged: the checksum of ranges is wrong";
  return good;
}

//------------------------------------------------------------------------------
void vtkMTPatchTable::Save(std::size_t first, std::vector<unsigned char>& bytes) const
{
  vtkMTBytes::Writer writer(bytes);
  for (std::size_t patch = first; patch < this->Patches.size(); ++patch)
  {
    const Entry& entry = this->Patches[patch];
    writer.Put(entry);
    writer.Put<std::uint64_t>(this->NumberOfRanges);
    for (std::size_t i = 0; i < entry.SectionCount; ++i)
    {
      writer.Put(this->Sections[entry.FirstSection + i]);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkMTPatchTable::Load(std::uint64_t patches, const std::vector<unsigned char>& bytes)
{
  *this = vtkMTPatchTable();
  vtkMTBytes::Reader reader(bytes);
  for (std::uint64_t patch = 0; reader.IsSound() && patch < patches; ++patch)
  {
    const auto entry = reader.Take<Entry>();
    this->NumberOfRanges = static_cast<std::size_t>(reader.Take<std::uint64_t>());
    for (std::size_t i = 0; reader.IsSound() && i < entry.SectionCount; ++i)
    {
      this->Sections.push_back(reader.Take<SectionRecord>());
    }
    this->Patches.push_back(entry);
  }
  return reader.IsSound() && reader.IsAtEnd();
}
