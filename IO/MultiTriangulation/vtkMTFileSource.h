// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFileSource
 * @brief a Multi-Triangulation file as a patch source
 *
 * Open reads header and DAG, checks their checksums and every length, offset, index and count in them, and keeps them
 * in memory; patches are read when they are asked for, by one positioned read for each run of neighbouring sections,
 * also across patches that are asked for together, and the checksum of each section is verified then. Only the sections
 * of the arrays that are asked for are read, and gaps between them of no more than MaximumGap bytes. The layout is in
 * Documentation/file-format.md.
 *
 * Threads: after Open, all const members may be called from any number of threads at once.
 */
#ifndef vtkMTFileSource_h
#define vtkMTFileSource_h

#include "vtkMTGraph.h"
#include "vtkMTIOModule.h" // For export macro
#include "vtkMTPatchSource.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkMTByteSource;

class VTKMTIO_EXPORT vtkMTFileSource : public vtkMTPatchSource
{
public:
  /// Bytes between two wanted sections that are rather read than skipped: a page, which the disk would read anyway.
  static constexpr std::uint64_t MaximumGap = 4096;
  /// Bytes of one read for several sections, at most.
  static constexpr std::uint64_t MaximumRead = std::uint64_t(1) << 22;

  vtkMTFileSource();
  ~vtkMTFileSource() override;

  ///@{
  /// False, with the reason in error, when the file is missing, of a newer version, damaged or no Multi-Triangulation;
  /// the source is then empty and may be opened again.
  bool Open(const std::string& path, std::string& error);
  bool Open(std::shared_ptr<const vtkMTByteSource> bytes, std::string& error);
  ///@}

  /// Whether the file begins as a Multi-Triangulation file does, of whatever version.
  static bool CanRead(const std::string& path);

  const vtkMTGraph& GetGraph() const override { return this->Graph; }
  bool ReadPatch(
    std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const override;
  void ReadPatches(const std::vector<std::uint32_t>& arcs, const std::vector<unsigned char>* arrays,
    const PatchUse& use) const override;
  std::uint64_t GetPatchPlace(std::uint32_t arc) const override;
  bool ReadBlob(std::uint32_t blob, std::vector<unsigned char>& bytes, std::string& error) const override;
  std::uint64_t GetPatchSize(std::uint32_t arc) const override;
  std::uint64_t GetDecodeSize(std::uint32_t arc) const override;
  std::string GetName() const override;

  /// Bytes that all patches together take for their geometry, then for each of the graph's arrays, padding counted.
  std::vector<std::uint64_t> GetSizeByKind() const;

  /// Bytes of the whole file; 0 when none is open.
  std::uint64_t GetFileSize() const;

private:
  struct Internals;
  bool PreparePatch(std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch,
    std::vector<unsigned char>& wanted, std::string& error) const;
  bool DecodeSection(
    std::uint32_t arc, std::size_t section, const unsigned char* data, vtkMTPatch& patch, std::string& error) const;
  bool TakePatch(std::uint32_t arc, const std::vector<unsigned char>* arrays, const unsigned char* bytes,
    std::uint64_t begin, vtkMTPatch& patch, std::string& error) const;

  std::unique_ptr<Internals> Implementation;
  vtkMTGraph Graph;
};

#endif
