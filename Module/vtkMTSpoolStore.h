// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSpoolStore
 * @brief makes the spools that a builder needs, in memory or on disk, and keeps a checkpoint of them
 *
 * Nameless spools are gone with their object, or with the process. Named ones stay until they are removed: Commit makes
 * all of them durable and then, in one step, a state: bytes that say what is in them. Whatever ends the process after
 * that, Restore gives the state of the last Commit, and the spools that existed then can be opened as they were: what
 * was appended later is removed, and a spool that was removed since is kept until the next Commit.
 *
 * A store in memory (vtkMTMemorySpoolStore) and one on disk (IO) give the same bytes: what is built does not depend on
 * which one it is.
 */
#ifndef vtkMTSpoolStore_h
#define vtkMTSpoolStore_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTSpool.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class VTKMTCORE_EXPORT vtkMTSpoolStore
{
public:
  virtual ~vtkMTSpoolStore() = default;

  ///@{
  /// A new spool; null on failure, with a message in error. A name must be new; it has letters, digits and '-' only.
  virtual std::unique_ptr<vtkMTSpool> Create(std::string& error) = 0;
  virtual std::unique_ptr<vtkMTSpool> Create(const std::string& name, std::string& error) = 0;
  ///@}
  /// The named spool with its first size bytes, which it must have; null on failure, with a message in error.
  virtual std::unique_ptr<vtkMTSpool> Open(const std::string& name, std::uint64_t size, std::string& error) = 0;
  virtual void Remove(const std::string& name) = 0;

  /// Whether Commit has an effect: whether a later process could go on from there.
  virtual bool IsLasting() const = 0;
  virtual bool Commit(const std::vector<unsigned char>& state, std::string& error) = 0;
  /// The state of the last Commit, empty when there is none. False when there is one that cannot be read.
  virtual bool Restore(std::vector<unsigned char>& state, std::string& error) = 0;
  /// Removes all that is left: named spools and the state.
  virtual void Clear() = 0;

  /// Bytes that all spools hold now, and the most that they have held at a time.
  virtual std::uint64_t GetSize() const = 0;
  virtual std::uint64_t GetLargestSize() const = 0;
};

#endif
