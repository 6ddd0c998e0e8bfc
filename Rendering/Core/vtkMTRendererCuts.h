// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRendererCuts
 * @brief one cut for each renderer that shows the model: what is drawn, kept while nothing changes
 *
 * Every pass of a frame (opaque, translucent, depth peeling, selection) asks again; as long as views and settings are
 * the same, so is the answer, without work. From frame to frame a cut that is not what the views ask for yet moves
 * towards it as patches arrive (vtkMTCutFollower). Patches that cannot be read count as not there for good, so the
 * coarser ones stay in the cut.
 *
 * A renderer is known by a key, any address that stands for it until Forget.
 */
#ifndef vtkMTRendererCuts_h
#define vtkMTRendererCuts_h

#include "vtkMTCutFollower.h"
#include "vtkMTPatchCache.h"
#include "vtkMTRenderingCoreModule.h" // For export macro
#include "vtkMTView.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

class vtkMTPatchSource;

class VTKMTRENDERINGCORE_EXPORT vtkMTRendererCuts
{
public:
  using Key = const void*;
  using ResultPointer = std::shared_ptr<const vtkMTCutFollower::Result>;

  struct Frame
  {
    std::vector<vtkMTView> Views; ///< of the renderer: one, or one for each eye
    vtkMTCutFollower::Settings Settings;
    bool Freeze = false;  ///< the cut that the renderer had before, seen from the new views
    bool Advance = false; ///< a new frame, not a further pass of one: the cut may move though the views are the same
    /// Whether an arc's patch is on the GPU.
    std::function<bool(std::uint32_t arc)> IsUploaded;
  };

  /// Forgets all cuts when the source is another one.
  bool SetSource(const std::shared_ptr<const vtkMTPatchSource>& source);
  const std::shared_ptr<const vtkMTPatchSource>& GetSource() const { return this->Source; }

  /// What to draw.
  ResultPointer Update(Key renderer, const Frame& frame, const vtkMTPatchCache& cache);

  /// Tells the cache what the renderers want, if that is another thing than before. At the end of a frame.
  void Post(vtkMTPatchCache& cache);
  /// The next Post tells it again: the cache has been asked for other things since.
  void PostAgain();
  void Forget(Key renderer, vtkMTPatchCache* cache);

  /// The next Update looks for the last one's cut again: something that it took for being there is not.
  void Invalidate();

  /// True the first time.
  bool MarkUnreadable(std::uint32_t arc);
  bool IsUnreadable(std::uint32_t arc) const { return this->Resident[arc] == 0; }

  /// What Update gave last, or null.
  const ResultPointer& GetLast() const { return this->Last; }
  /// How often a cut was looked for: while it stays the same, what Update gives is the same object with the same cut.
  std::uint64_t GetNumberOfSearches() const { return this->Searches; }
  /// Seconds that the last new cut took.
  double GetCutTime() const { return this->CutTime; }

private:
  struct Kept
  {
    std::vector<vtkMTView> Views;
    vtkMTCutFollower::Settings Settings;
    bool Frozen = false;
    std::uint64_t Readable = 0;
    vtkMTCutFollower Follower;
    ResultPointer Result;
    bool Posted = true; // the cache knows what the result wants
  };

  void Compute(Kept& kept, const Frame& frame, bool keepCut, const vtkMTPatchCache& cache);

  std::shared_ptr<const vtkMTPatchSource> Source;
  std::map<Key, Kept> All;
  std::vector<unsigned char> Resident;
  std::uint64_t ReadableRevision = 0;
  ResultPointer Last;
  std::uint64_t Searches = 0;
  double CutTime = 0.0;
};

#endif
