// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchSource
 * @brief where patches come from: a file, a store in memory, a server
 *
 * The waist of the hourglass: cut extraction, cache, mapper, extraction to a mesh and verification know a
 * Multi-Triangulation through this class only. It is no vtkObject: loader threads use it.
 *
 * Threads: all const members may be called from any number of threads at once.
 */
#ifndef vtkMTPatchSource_h
#define vtkMTPatchSource_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkMTGraph;

class VTKMTCORE_EXPORT vtkMTPatchSource
{
public:
  virtual ~vtkMTPatchSource();

  /// The whole graph. A source that knows a part of it only reads or waits for the rest; where that fails, the graph
  /// stays partly known, and GetGraphError says why.
  virtual const vtkMTGraph& GetGraph() const = 0;

  /// The same object, as far as it is known now. Never waits: for renderers, which look at the known part only. What
  /// is not graph (lattice, arrays, blobs, ranges, settings) is there at once.
  virtual const vtkMTGraph& GetKnownGraph() const;

  /// Why the rest of the graph cannot be read; empty as long as it may still come, or is there. Never waits.
  virtual std::string GetGraphError() const;

  /**
   * Reads one arc's patch, of a known arc; that of a dependency is empty. arrays, when given, has one entry per array
   * of the graph: 0 leaves that array's column empty; nullptr reads all. False on failure: then error says what failed
   * and where, and patch is empty.
   */
  virtual bool ReadPatch(
    std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const = 0;

  /// Takes one of ReadPatches' patches: its place in the list of arcs, whether it could be read, and if not, why.
  using PatchUse = std::function<void(std::size_t index, bool read, vtkMTPatch& patch, const std::string& error)>;

  /**
   * Reads the patches of several arcs, with arrays as for ReadPatch, and hands over one after the other, in the order
   * of the list. A source that reads from a store of bytes reads neighbours together; so the list should be in the
   * order of GetPatchPlace. A patch that cannot be read does not keep the others from being read. use takes each patch
   * once.
   */
  virtual void ReadPatches(
    const std::vector<std::uint32_t>& arcs, const std::vector<unsigned char>* arrays, const PatchUse& use) const;

  /// The bytes of one of the graph's blobs. False on failure, as ReadPatch; a source without blobs need not have it.
  virtual bool ReadBlob(std::uint32_t blob, std::vector<unsigned char>& bytes, std::string& error) const;

  /// Bytes that reading the arc's patch with all arrays takes from the store; an estimate for budgets.
  virtual std::uint64_t GetPatchSize(std::uint32_t arc) const = 0;

  /// Bytes that decoding the arc's patch takes at most, beside the patch itself and what is read from the store. The
  /// default, 0, is for stores that keep patches as they are.
  virtual std::uint64_t GetDecodeSize(std::uint32_t arc) const;

  /// Where the arc's patch begins in the store, in bytes: patches whose places follow each other can be read together.
  /// The default: the arc's index, for stores whose patches have no places.
  virtual std::uint64_t GetPatchPlace(std::uint32_t arc) const;

  /// For messages: a file name, "memory".
  virtual std::string GetName() const = 0;
};

#endif
