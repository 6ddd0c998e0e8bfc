// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFileSource
 * @brief a Multi-Triangulation file as a patch source
 *
 * Open reads header, metadata and the whole graph, checks their checksums and every length, offset, index and count in
 * them, and keeps them in memory; patches are read when they are asked for, by one positioned read for each run of
 * neighbouring sections, also across patches that are asked for together, and the checksum of each section is verified
 * then. Only the sections of the arrays that are asked for are read, and gaps between them of no more than MaximumGap
 * bytes. The layout is in Documentation/file-format.md.
 *
 * OpenFirstPages reads what the coarsest cut needs and no more, a few pages however large the model is. The rest of the
 * graph follows with ReadOn, on a thread of the source's own with StartReadingOn, or with the first call of GetGraph;
 * GetKnownGraph shows at any time how far that is.
 *
 * Threads: after it has been opened, all const members may be called from any number of threads at once. ReadOn and,
 * where the graph is not whole, GetGraph wait for each other; nothing else waits.
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

  ///@{
  /// The same with the coarsest part of the graph alone.
  bool OpenFirstPages(const std::string& path, std::string& error);
  bool OpenFirstPages(std::shared_ptr<const vtkMTByteSource> bytes, std::string& error);
  ///@}

  /**
   * Reads more of the graph: until so many bytes have been read, a page at least, or it is whole. False, with the
   * reason in error, when that failed, now or earlier; what was known stays.
   */
  bool ReadOn(std::uint64_t bytes, std::string& error) const;
  /// Reads all of it, on a thread that ends when that is done or the source is closed. A failure is ReadOn's from then
  /// on.
  void StartReadingOn();
  /// Bytes of the graph, header and metadata that have been read.
  std::uint64_t GetGraphBytesRead() const;

  /// Whether the file begins as a Multi-Triangulation file does, of whatever version.
  static bool CanRead(const std::string& path);

  const vtkMTGraph& GetGraph() const override;
  const vtkMTGraph& GetKnownGraph() const override;
  std::string GetGraphError() const override;
  bool ReadPatch(
    std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const override;
  void ReadPatches(const std::vector<std::uint32_t>& arcs, const std::vector<unsigned char>* arrays,
    const PatchUse& use) const override;
  std::uint64_t GetPatchPlace(std::uint32_t arc) const override;
  bool ReadBlob(std::uint32_t blob, std::vector<unsigned char>& bytes, std::string& error) const override;
  std::uint64_t GetPatchSize(std::uint32_t arc) const override;
  std::uint64_t GetDecodeSize(std::uint32_t arc) const override;
  std::string GetName() const override;

  /// Bytes that all patches together take for their geometry, then for each of the graph's arrays, padding counted. Of
  /// the whole graph.
  std::vector<std::uint64_t> GetSizeByKind() const;

  /// Bytes of the whole file; 0 when none is open.
  std::uint64_t GetFileSize() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
