// SPDX-License-Identifier: BSD-3-Clause
// Reads and decodes the patches of a Multi-Triangulation file. Not installed.
#ifndef vtkMTFilePatches_h
#define vtkMTFilePatches_h

#include "vtkMTFileTables.h"
#include "vtkMTGraph.h"
#include "vtkMTPatch.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkMTByteSource;

class vtkMTFilePatches
{
public:
  /// They must outlive this object.
  vtkMTFilePatches(const vtkMTByteSource& source, const vtkMTGraph& graph, const vtkMTFileTables& tables)
    : Source(source)
    , Graph(graph)
    , Tables(tables)
  {
  }

  /// A range of bytes that holds the wanted sections of some patches.
  struct Run
  {
    std::uint64_t Begin = 0;
    std::uint64_t End = 0;
  };

  /// Takes the wanted sections of a patch into the range; false, and nothing done, when the range would become too long
  /// or would have too wide a gap.
  bool Extend(Run& run, std::uint32_t arc, const std::vector<unsigned char>* arrays) const;

  /**
   * One patch: out of bytes that have been read already and begin at `begin`, or, where bytes is null, with reads of
   * its own, neighbouring sections together. Of arrays and errors see vtkMTPatchSource::ReadPatch.
   */
  bool Read(std::uint32_t arc, const std::vector<unsigned char>* arrays, const unsigned char* bytes,
    std::uint64_t begin, vtkMTPatch& patch, std::string& error) const;

  bool ReadBlob(std::uint32_t blob, std::vector<unsigned char>& bytes, std::string& error) const;

private:
  static bool IsWanted(const vtkMTFileSection& section, const std::vector<unsigned char>* arrays);
  bool Decode(std::uint32_t arc, const std::vector<unsigned char>* arrays, const unsigned char* bytes,
    std::uint64_t begin, vtkMTPatch& patch, std::string& error) const;
  bool ReadSections(std::uint32_t arc, const std::vector<vtkMTFileSection>& sections, vtkMTPatch& patch,
    std::string& error) const;
  bool DecodeSection(std::uint32_t arc, const vtkMTFileSection& section, const unsigned char* data, vtkMTPatch& patch,
    std::string& error) const;
  vtkMTColumn& GetColumn(std::size_t array, vtkMTPatch& patch) const;

  const vtkMTByteSource& Source;
  const vtkMTGraph& Graph;
  const vtkMTFileTables& Tables;
};

#endif
