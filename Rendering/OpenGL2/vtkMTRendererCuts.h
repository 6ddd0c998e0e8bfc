// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRendererCuts
 * @brief one cut per renderer and view: what is drawn, kept while nothing changes
 *
 * Every pass of a frame (opaque, translucent, depth peeling, selection) asks again; as long as view and settings are
 * the same, so is the answer, without work. From frame to frame a cut that is not what the view asks for yet moves
 * towards it as patches arrive (vtkMTCutFollower). Patches that cannot be read count as not there for good, so the
 * coarser ones stay in the cut.
 */
#ifndef vtkMTRendererCuts_h
#define vtkMTRendererCuts_h

#include "vtkMTCutFollower.h"
#include "vtkMTPatchCache.h"
#include "vtkMTView.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <vector>

class vtkMTPatchSource;
class vtkRenderer;

class vtkMTRendererCuts
{
public:
  struct Frame
  {
    vtkMTView View;
    vtkMTCutFollower::Settings Settings;
    bool Freeze = false;  ///< the cut that the renderer had before, seen from the new view
    bool Advance = false; ///< a new frame, not a further pass of one: the cut may move though the view is the same
    /// Whether an arc's patch is on the GPU.
    std::function<bool(std::uint32_t arc)> IsUploaded;
  };

  /// Forgets all cuts when the source is another one.
  bool SetSource(const std::shared_ptr<const vtkMTPatchSource>& source);
  const std::shared_ptr<const vtkMTPatchSource>& GetSource() const { return this->Source; }

  /// What to draw.
  const vtkMTCutFollower::Result& Update(vtkRenderer* renderer, const Frame& frame, const vtkMTPatchCache& cache);

  /// Tells the cache what the renderers want, if that is another thing than before. At the end of a frame.
  void Post(vtkMTPatchCache& cache);

  /// The next Update looks for the last one's cut again: something that it took for being there is not.
  void Invalidate();

  /// True the first time.
  bool MarkUnreadable(std::uint32_t arc);
  bool IsUnreadable(std::uint32_t arc) const { return this->Resident[arc] == 0; }

  /// What Update gave last, or null.
  const vtkMTCutFollower::Result* GetLast() const { return this->Last.get(); }
  /// How often a cut was looked for: while it stays the same, what Update gives is the same object with the same cut.
  std::uint64_t GetNumberOfSearches() const { return this->Searches; }
  /// Seconds that the last new cut took.
  double GetCutTime() const { return this->CutTime; }

private:
  struct Kept
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkMTView View;
    vtkMTCutFollower::Settings Settings;
    bool Frozen = false;
    std::uint64_t Readable = 0;
    std::unique_ptr<vtkMTCutFollower> Follower;
    std::shared_ptr<vtkMTCutFollower::Result> Result;
    bool Posted = true; // the cache knows what the result wants
  };

  Kept& Find(vtkRenderer* renderer);
  void Compute(Kept& kept, const Frame& frame, bool keepCut, const vtkMTPatchCache& cache);

  std::shared_ptr<const vtkMTPatchSource> Source;
  std::list<Kept> All;
  std::vector<const void*> Gone; // views whose renderer is no more
  std::vector<unsigned char> Resident;
  std::uint64_t ReadableRevision = 0;
  std::shared_ptr<vtkMTCutFollower::Result> Last;
  std::uint64_t Searches = 0;
  double CutTime = 0.0;
};

#endif
