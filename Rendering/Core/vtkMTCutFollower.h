// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCutFollower
 * @brief the cut on the screen: follows the view from frame to frame, with what is there
 *
 * The time-critical half of Cignoni et al., "Batched Multi Triangulation" (2005), section 5. Two cuts are
 * distinguished. The *target* is what the view asks for: vtkMTTargetCut's, from the coarsest cut on, as if every patch
 * were on the GPU. It is a pure function of graph, view, budgets and of which patches can be read at all. The *cut* is
 * what is drawn. It is kept from the last frame and moved towards the target by two heaps of operations:
 *
 * - the coarsening heap holds refined nodes that the target does not refine, the smallest error first;
 * - the refinement heap holds nodes that the target refines and that can be refined, the largest error first.
 *
 * An operation is feasible when the patches that it brings into the picture are in main memory or on the GPU, and those
 * that are not on the GPU yet fit the upload budget of the frame, and no budget is exceeded afterwards. When the target
 * itself can be drawn, it is taken at once. What is missing is asked for: Wants says which patches, and how urgently.
 *
 * Before that, two things are put right whatever the time, because the camera has moved: where a patch of the last cut
 * has come into view that is not there, and where a budget is exceeded, the cut is coarsened, if need be down to the
 * coarsest one, whose patches are always drawn. Each takes at most one operation for each refined node.
 *
 * Guarantees. After any operation, and so whenever time is over: the cut is closed, so its patches conform; everything
 * drawn is there; no budget is exceeded, unless by the coarsest cut. While nothing changes but that patches arrive, the
 * cut becomes the target, which does not depend on the path that led there, as soon as the target's patches are there
 * and what is not on the GPU fits the upload budget; in between, it depends on which patches happened to arrive.
 *
 * Where the time budget ends the search for the target, half of it is spent on that. Then the cut is moved by what its
 * own nodes' errors say, from where it is, so that it gets finer from frame to frame all the same.
 *
 * Threads: one object per view, used by one thread at a time. It holds no lock and waits for nothing.
 */
#ifndef vtkMTCutFollower_h
#define vtkMTCutFollower_h

#include "vtkMTPatchCache.h"
#include "vtkMTRenderingCoreModule.h" // For export macro
#include "vtkMTTargetCut.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

class VTKMTRENDERINGCORE_EXPORT vtkMTCutFollower
{
public:
  enum StateType : std::uint8_t
  {
    Absent = 0,  ///< cannot be drawn in this frame
    Loaded = 1,  ///< in main memory: can be drawn after an upload
    Uploaded = 2 ///< on the GPU
  };

  struct Settings : vtkMTTargetCut::Settings
  {
    /// Bytes, as ByteLimit counts them, that are brought to the GPU in a frame; 0, the default, is no limit. The
    /// coarsest patches do not count. A patch of more than that is never drawn: it should be a few times what the
    /// largest patch has.
    std::uint64_t UploadBudget = 0;
    /// Whether patches around the cut are asked for when the frame has time left: the coarser ones on the way back, the
    /// next finer ones, and those just outside the frustum. Default on.
    bool Prefetch = true;
    /// Whether to take everything for being there, because the frame will wait for what is not. Default off.
    bool Wait = false;
  };

  struct Input : vtkMTTargetCut::Input
  {
    /// Of an arc's patch, asked once a frame at most; none: everything is uploaded. (Resident, of the base, says here
    /// which patches can be read at all.)
    std::function<StateType(std::uint32_t arc)> GetState;
  };

  struct Result : vtkMTTargetCut::Result
  {
    explicit Result(const vtkMTGraph& graph)
      : vtkMTTargetCut::Result(graph)
    {
    }
    explicit Result(vtkMTTargetCut::Result&& base)
      : vtkMTTargetCut::Result(std::move(base))
    {
    }

    bool OnTarget = true; ///< the cut is what the view asks for
    /// Not drawn yet: on the GPU, to be kept there, or to be uploaded as well, because the refinement that needs them
    /// brings more than one frame may upload.
    std::vector<std::uint32_t> Early;
    std::uint64_t UploadBytes = 0; ///< of Arcs and Early that are not on the GPU, the coarsest not counted
    std::size_t Refined = 0;       ///< operations of this frame
    std::size_t Coarsened = 0;     ///< operations towards the target
    std::size_t Forced = 0;        ///< coarsened because something was not there, or for a budget
    /// For vtkMTPatchCache: what this view wants loaded and kept. Above 0 what the cut needs and what would refine it,
    /// by its error; 0 what is drawn and on the GPU; below 0 what is around the cut.
    std::vector<vtkMTPatchCache::Want> Wants;
  };

  vtkMTCutFollower();
  ~vtkMTCutFollower();
  vtkMTCutFollower(const vtkMTCutFollower&) = delete;
  vtkMTCutFollower& operator=(const vtkMTCutFollower&) = delete;

  /// Moves the cut towards what the view asks for. Another graph than in the last call begins at its coarsest cut.
  Result Update(const Input& input, const Settings& settings);

  /// The cut of the last call, in a new view, without any operation.
  vtkMTTargetCut::Result View(const Input& input, const Settings& settings);

  /// The next call begins at the coarsest cut.
  void Reset();

private:
  class Worker;
  vtkMTTargetCut Extraction;
  std::unique_ptr<vtkMTCut> Cut;
  std::vector<std::uint32_t> RefinedNodes; // of Cut, ascending
  const vtkMTGraph* Graph = nullptr;
  std::vector<unsigned char> States; // of the frame's arcs; Unknown between calls
  std::vector<std::uint32_t> Asked;
};

#endif
