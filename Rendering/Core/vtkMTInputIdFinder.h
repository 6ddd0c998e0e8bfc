// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputIdFinder
 * @brief which cell, or which point, of the input is at a place on a coarse patch
 *
 * Models keep the input's ids on the finest level. For a place on a coarser patch this finds the triangle of the finest
 * level that is nearest to it and faces the way that the patch does there, so that a thin wall's other side is not
 * taken; where none within the patch's certified distance does, the nearest one. Of equally near ones it is the one
 * with the smallest id. Input points are found likewise, by distance alone.
 *
 * Only those patches are read that can hold the nearest triangle (vtkMTFinestNear), with nothing but the ids: one to
 * three for a place. Those of many places are read together, each of them once as long as they fit the limit, and
 * looked at by several threads.
 *
 * Results depend on the model and the places alone. The whole graph is asked for, so with a model that is still being
 * read this waits until the graph is there; where it cannot be read no id is known.
 *
 * Threads: one object per thread. Its own threads live within Find and touch the source and nothing else; resident
 * patches are asked for on the calling thread.
 */
#ifndef vtkMTInputIdFinder_h
#define vtkMTInputIdFinder_h

#include "vtkMTArrayInfo.h"
#include "vtkMTRenderingCoreModule.h" // For export macro

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkMTPatchSource;
struct vtkMTPatch;

class VTKMTRENDERINGCORE_EXPORT vtkMTInputIdFinder
{
public:
  using Place = std::array<double, 3>;

  struct Query
  {
    std::uint32_t Arc = 0; ///< whose patch the place is on
    Place X{};             ///< model units
    Place Direction{};     ///< the normal there, of any length; zero: it does not count
  };

  /// A patch that is in memory, with whatever arrays, or null.
  using Resident = std::function<std::shared_ptr<const vtkMTPatch>(std::uint32_t arc)>;
  /// Takes a fraction; false stops.
  using Progress = std::function<bool(double)>;

  struct Settings
  {
    /// Bytes of patches that are kept, at most, beside the one that each thread looks at.
    std::size_t MemoryLimit = std::size_t(64) << 20;
    /// 1 to 64; few places are done by the calling thread.
    int Threads = 2;
  };

  static constexpr vtkIdType Unknown = -1;

  /// role: InputCellIds or InputPointIds.
  vtkMTInputIdFinder(const vtkMTPatchSource& source, vtkMTArrayInfo::RoleType role);
  vtkMTInputIdFinder(const vtkMTPatchSource& source, vtkMTArrayInfo::RoleType role, const Settings& settings);
  ~vtkMTInputIdFinder();

  /// Whether the model keeps such ids.
  bool HasIds() const;

  void SetResident(const Resident& resident);

  /**
   * An id for each query, Unknown where the graph or a patch cannot be read; then error says why, and the result is
   * false. False without an error where progress stopped it: what had been found until then is there.
   */
  bool Find(const std::vector<Query>& queries, std::vector<vtkIdType>& ids, std::string& error,
    const Progress& progress = Progress());

  ///@{
  /// Since construction: patches read, and nodes of the graph looked at.
  std::uint64_t GetNumberOfReads() const;
  std::uint64_t GetNumberOfNodes() const;
  ///@}

private:
  class Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
