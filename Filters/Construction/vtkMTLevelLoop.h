// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLevelLoop
 * @brief the construction itself: from a mesh on the lattice to patches in a sink and their DAG
 *
 * BMT section 4. Mesh M_0 is the input. On every level i the fragments of the regions of Psi_i together are the mesh
 * M_i. One turn of the loop places the regions of Psi_(i+1) by the barycentres of M_i, splits the fragments into the
 * patches of the crossing (each patch is an arc from the node of its Psi_(i+1) region to that of its Psi_i region, or
 * to the sink), puts the patches of each Psi_(i+1) region together as a floor and simplifies it to half its triangles:
 * M_(i+1). The loop ends when one region is left with no more triangles than a patch should have, or when two turns in
 * a row removed less than a tenth of the triangles; the last fragments are the arcs that leave the source.
 *
 * Threads: fragments and regions are taken in batches, in parallel within a batch; what a batch made goes to sink and
 * spools in order of index, by the calling thread.
 */
#ifndef vtkMTLevelLoop_h
#define vtkMTLevelLoop_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTGraph.h"
#include "vtkMTPatch.h"

#include <functional>
#include <memory>
#include <string>

class vtkMTPartitionStrategy;
class vtkMTPatchSink;
class vtkMTSimplifier;
class vtkMTSpool;
struct vtkMTInputMesh;

class VTKMTCONSTRUCTION_EXPORT vtkMTLevelLoop
{
public:
  struct Settings
  {
    std::size_t PatchTriangles = 1000;
    int NumberOfThreads = 0; ///< 0: as many as the machine has
    const vtkMTPartitionStrategy* Partition = nullptr;
    const vtkMTSimplifier* Simplifier = nullptr;
    /// Called now and then with the fraction done; false stops the work.
    std::function<bool(double)> Progress;
  };

  /**
   * Triangles of a region of Psi_i on M_i over those of a patch: a crossing with the next partition, of half as many
   * regions, cuts a region into about this many patches once slivers are merged (measured on scans and fractal spheres:
   * Testing/Construction prints the mean patch of every model that it builds).
   */
  static constexpr double PatchesPerRegion = 2.9;
  /// Elements of a crossing below this share of the wanted patch are merged into a neighbour.
  static constexpr double SliverShare = 0.1;

  vtkMTLevelLoop(const Settings& settings, vtkMTPatchSink& sink, vtkMTSpool& fragments, vtkMTSpool& patches);
  ~vtkMTLevelLoop();

  /// Consumes the input. False on failure, with a message in GetError; the sink is then neither finished nor abandoned.
  bool Run(vtkMTInputMesh&& input);

  const std::string& GetError() const;
  bool WasAborted() const;

private:
  class Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
