// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLevelLoop
 * @brief the construction itself: from the fragments of a mesh on the lattice to patches in a sink and their DAG
 *
 * BMT section 4. Mesh M_0 is the input. On every level i the fragments of the regions of Psi_i together are the mesh
 * M_i. One turn of the loop (vtkMTSplitStep, vtkMTSimplifyStep) places the regions of Psi_(i+1) by the barycentres of
 * M_i, splits the fragments into the patches of the crossing (each patch is an arc from the node of its Psi_(i+1)
 * region to that of its Psi_i region, or to the sink), assembles the patches of each Psi_(i+1) region as a floor and
 * simplifies it to half its triangles (the strategy's reduction): M_(i+1). The loop ends when one region is left with
 * no more triangles than a patch should have, or when two turns in a row removed less than a tenth of the triangles;
 * the last fragments are the arcs that leave the source.
 *
 * Memory: fragments and patches are in spools, and only those that are worked on are in memory. What grows with the
 * mesh is a few dozen bytes per region and the DAG's records.
 *
 * Threads: fragments and regions are worked on in parallel (vtkMTOrderedWork); what they make goes to sink and spools
 * in order of index, by the calling thread.
 *
 * Checkpoints: when both the store and the sink can go on in another process, the state is committed after each of a
 * level's two steps.
 */
#ifndef vtkMTLevelLoop_h
#define vtkMTLevelLoop_h

#include "vtkMTBuildSettings.h"
#include "vtkMTConstructionModule.h" // For export macro

#include <memory>
#include <string>
#include <vector>

class vtkMTSequenceState;
class vtkMTPatchSink;

class VTKMTCONSTRUCTION_EXPORT vtkMTLevelLoop
{
public:
  /// identity: kept in every checkpoint (vtkMTCheckpoint).
  vtkMTLevelLoop(const vtkMTBuildSettings& settings, vtkMTPatchSink& sink, const std::string& identity);
  ~vtkMTLevelLoop();

  /**
   * Goes on from the state to the end. The sink has begun, or was restored. False on failure, with a message in
   * GetError; the sink is then neither finished nor abandoned.
   */
  bool Run(vtkMTSequenceState& state);

  const std::string& GetError() const;
  bool WasAborted() const;
  /// Whether a checkpoint has been committed.
  bool HasCheckpoint() const;

private:
  class Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
