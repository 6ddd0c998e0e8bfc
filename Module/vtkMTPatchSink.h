// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchSink
 * @brief where the builder puts patches: a file writer, a store in memory
 *
 * The builder calls Begin once, then WritePatch for patch 0, 1, 2 ... in an order that depends on the input and the
 * settings alone (finest level first), then Finish with the finished graph, whose arc i carries the patch that was
 * written as number patchOfArc[i]; or Abandon, after which nothing of the model must remain. A sink publishes its model
 * whole in Finish or not at all. All calls come from one thread, but for Prepare, which does what can be done to a
 * patch without the others, such as encoding, and may be called by any number of threads between Begin and Finish.
 *
 * A sink may be able to go on in another process: Save gives what Restore needs, in place of Begin, to be again as it
 * was at the time of Save. Patches that were written after that are forgotten.
 */
#ifndef vtkMTPatchSink_h
#define vtkMTPatchSink_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkMTGraph;

class VTKMTCORE_EXPORT vtkMTPatchSink
{
public:
  virtual ~vtkMTPatchSink();

  /// arrays: what the columns of all patches are. False on failure, with a message in GetError.
  virtual bool Begin(const std::vector<vtkMTArrayInfo>& arrays) = 0;
  virtual bool WritePatch(vtkMTPatch&& patch) = 0;

  ///@{
  /// The same in two steps. Prepare gives null on failure, with a message in error.
  struct VTKMTCORE_EXPORT PreparedPatch
  {
    virtual ~PreparedPatch();
  };
  virtual std::unique_ptr<PreparedPatch> Prepare(vtkMTPatch&& patch, std::string& error) const;
  virtual bool WritePrepared(std::unique_ptr<PreparedPatch> patch);
  ///@}

  /// The bytes of the graph's blobs, in their order, at any time between Begin and Finish.
  virtual bool WriteBlob(std::vector<unsigned char>&& bytes) = 0;
  virtual bool Finish(const vtkMTGraph& graph, const std::vector<std::uint32_t>& patchOfArc) = 0;
  virtual void Abandon() = 0;

  ///@{
  /// False when the sink cannot go on in another process, as a sink in memory cannot; that is no error.
  virtual bool Save(std::vector<unsigned char>& state);
  virtual bool Restore(const std::vector<vtkMTArrayInfo>& arrays, const std::vector<unsigned char>& state);
  ///@}

  const std::string& GetError() const { return this->Error; }

protected:
  std::string Error;
};

#endif
