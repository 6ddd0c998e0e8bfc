// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCheckpoint
 * @brief what a build can go on from in another process: whose build it is, and the bytes of its state and its sink
 *
 * A spool store that lasts keeps one checkpoint at a time, together with the spools as they are then.
 */
#ifndef vtkMTCheckpoint_h
#define vtkMTCheckpoint_h

#include "vtkMTFiltersCoreModule.h" // For export macro

#include <string>
#include <vector>

class vtkMTSpoolStore;

struct VTKMTFILTERSCORE_EXPORT vtkMTCheckpoint
{
  std::string Identity; ///< of input and settings: a build goes on from its own checkpoint only
  std::vector<unsigned char> State;
  std::vector<unsigned char> Sink;

  bool IsEmpty() const { return this->State.empty(); }

  ///@{
  /// False with a message in error. A store without a checkpoint gives an empty one.
  bool Write(vtkMTSpoolStore& store, std::string& error) const;
  bool Read(vtkMTSpoolStore& store, std::string& error);
  ///@}
};

#endif
