// SPDX-License-Identifier: BSD-3-Clause
// Where the patches and blobs of a Multi-Triangulation file lie. Not installed.
#ifndef vtkMTFileTables_h
#define vtkMTFileTables_h

#include "vtkMTFileFormat.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// A section and where its bytes lie.
struct vtkMTFileSection : vtkMTFileFormat::SectionRecord
{
  std::uint64_t Offset = 0;

  std::uint64_t GetEnd() const { return this->Offset + vtkMTFileFormat::Align(this->StoredSize); }
  bool IsGeometry() const { return this->Class == vtkMTFileFormat::GeometryClass; }
  bool IsArray() const
  {
    return this->Class >= vtkMTFileFormat::FirstArrayClass && this->Class < vtkMTFileFormat::OtherClasses;
  }
  /// Where IsArray.
  std::size_t GetArray() const { return static_cast<std::size_t>(this->Class) - vtkMTFileFormat::FirstArrayClass; }
};

struct vtkMTFileTables
{
  /// The sections of an arc's patch follow each other, in the table and in the file.
  struct Place
  {
    std::uint64_t Offset = 0;
    std::uint32_t FirstSection = 0;
    std::uint32_t SectionCount = 0;
  };
  std::vector<Place> Patches;                            // by arc
  std::vector<std::uint64_t> Blobs;                      // offsets; their sections are the first ones
  std::vector<vtkMTFileFormat::SectionRecord> Sections;

  /// Of one patch, in their order.
  std::vector<vtkMTFileSection> GetSections(std::uint32_t arc) const
  {
    const Place& place = this->Patches[arc];
    std::vector<vtkMTFileSection> sections(place.SectionCount);
    std::uint64_t next = place.Offset;
    for (std::uint32_t i = 0; i < place.SectionCount; ++i)
    {
      static_cast<vtkMTFileFormat::SectionRecord&>(sections[i]) = this->Sections[place.FirstSection + i];
      sections[i].Offset = next;
      next = sections[i].GetEnd();
    }
    return sections;
  }
  vtkMTFileSection GetBlob(std::uint32_t blob) const
  {
    vtkMTFileSection section;
    static_cast<vtkMTFileFormat::SectionRecord&>(section) = this->Sections[blob];
    section.Offset = this->Blobs[blob];
    return section;
  }
};

#endif
