// SPDX-License-Identifier: BSD-3-Clause
/**
 * The patches that a file sink has put into its spool: what they hold, and where. Not installed.
 *
 * In the spool each patch is followed by the ranges of its arrays and their checksum, which are asked for again when it
 * is known which patches are the finest.
 */
#ifndef vtkMTPatchTable_h
#define vtkMTPatchTable_h

#include "vtkMTFileTables.h"
#include "vtkMTGraph.h"
#include "vtkMTPatch.h"
#include "vtkMTPatchSink.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkMTSpool;

/// What a patch and its arc's record must have in common.
struct vtkMTPatchCounts
{
  std::uint32_t Points = 0;
  std::uint32_t Wedges = 0;
  std::uint32_t Triangles = 0;
  std::uint32_t SharedPoints = 0;
  vtkMTPatchKind Kind = vtkMTPatchKind::Triangles;

  static vtkMTPatchCounts Of(const vtkMTPatch& patch)
  {
    return { static_cast<std::uint32_t>(patch.Points.size()), static_cast<std::uint32_t>(patch.GetNumberOfWedges()),
      static_cast<std::uint32_t>(patch.Triangles.size()), static_cast<std::uint32_t>(patch.Ids.size()), patch.Kind };
  }
  static vtkMTPatchCounts Of(const vtkMTArc& arc)
  {
    return { arc.Points, arc.Wedges, arc.Triangles, arc.SharedPoints, arc.Kind };
  }
  bool operator==(const vtkMTPatchCounts& other) const
  {
    return this->Points == other.Points && this->Wedges == other.Wedges && this->Triangles == other.Triangles &&
      this->SharedPoints == other.SharedPoints && this->Kind == other.Kind;
  }
};

/// A patch made ready to be written.
struct vtkMTEncodedPatch : public vtkMTPatchSink::PreparedPatch
{
  std::vector<unsigned char> Bytes;
  std::vector<vtkMTFileSection> Sections; // offsets from the patch's first byte
  std::vector<vtkMTRange> Ranges;         // of all components of all arrays
  vtkMTPatchCounts Counts;
};

class vtkMTPatchTable
{
public:
  std::size_t GetNumberOfPatches() const { return this->Patches.size(); }
  const vtkMTPatchCounts& GetCounts(std::uint32_t patch) const { return this->Patches[patch].Counts; }
  std::uint16_t GetNumberOfSections(std::uint32_t patch) const { return this->Patches[patch].SectionCount; }
  /// Their offsets are in the spool.
  std::vector<vtkMTFileSection> GetSections(std::uint32_t patch) const;

  /// Appends the patch to the spool and to the table.
  bool Append(const vtkMTEncodedPatch& patch, vtkMTSpool& spool, std::string& error);
  bool ReadRanges(
    std::uint32_t patch, const vtkMTSpool& spool, std::vector<vtkMTRange>& ranges, std::string& error) const;

  ///@{
  /// The table as bytes, from a patch on, and what Load needs to be as it was. Load expects patches of those bytes.
  void Save(std::size_t first, std::vector<unsigned char>& bytes) const;
  bool Load(std::uint64_t patches, const std::vector<unsigned char>& bytes);
  ///@}

private:
  struct Entry
  {
    std::uint64_t Offset = 0; // in the spool
    std::uint32_t FirstSection = 0;
    std::uint16_t SectionCount = 0;
    vtkMTPatchCounts Counts;
  };
  std::vector<Entry> Patches;
  std::vector<vtkMTFileFormat::SectionRecord> Sections;
  std::size_t NumberOfRanges = 0; // of each patch
};

#endif
