// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFrame
 * @brief the protocol of a frame: what it draws, what it waits for, what it uploads, and what it does about failures
 *
 * For mappers of any kind (triangles, points, volumes): it knows nothing of OpenGL but a vtkMTUploader, and no
 * vtkObject. It owns the source of the patches, a cut for each renderer (vtkMTRendererCuts) and the patches in main
 * memory (vtkMTPatchCache). Each pass of a frame calls Update, and then draws the patches of the cut that it gives,
 * which are then on the GPU:
 *
 * 1. In the first pass, what the loader has brought is taken in, and failures are noted.
 * 2. The cut moves towards what the views ask for, with what is there; a frame that waits takes all that they ask for.
 * 3. What of it is not on the GPU is uploaded. A frame that waits has the missing patches loaded first; any other waits
 *    for nothing but the coarsest patches, without which there would be nothing to draw.
 * 4. A patch that cannot be read is taken for not there for good, and another cut is found, with the coarser patch in
 *    its place; where the uploader has no room, likewise, with a lower limit.
 * 5. The loader is told what the renderers want now.
 *
 * Several renderers may show the model through one uploader, in one window, or through one each, in several. What the
 * others drew since this renderer's last frame has a claim to the GPU's memory too: the uploader is told of it, and
 * where there are several of them each may fill its share of the limit only. So renderers do not drop each other's
 * patches, and where nothing moves nothing is uploaded.
 *
 * Threads: all calls come from the thread that draws; the cache's loader has threads of its own.
 */
#ifndef vtkMTFrame_h
#define vtkMTFrame_h

#include "vtkMTCutFollower.h"
#include "vtkMTPatchCache.h"
#include "vtkMTPatchLoader.h"
#include "vtkMTRendererCuts.h"
#include "vtkMTRenderingCoreModule.h" // For export macro
#include "vtkMTUploader.h"
#include "vtkMTView.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkMTGraph;
class vtkMTPatchSource;

class VTKMTRENDERINGCORE_EXPORT vtkMTFrame
{
public:
  using Key = vtkMTRendererCuts::Key;
  using Result = vtkMTCutFollower::Result;

  struct Settings
  {
    /// What the cut is to be. Wait: the frame waits for what it draws, whatever TimeLimit and UploadBudget say.
    /// ByteLimit and the bytes of vertices and triangles are set by the frame. Prefetch: while the camera moves, or
    /// may.
    vtkMTCutFollower::Settings Cut;
    /// Whether the cut stays what it was while the camera moves. Default off.
    bool Freeze = false;
    /// The first pass of a frame. Only there the cut moves though the view is the same, and Wait is looked at. Default
    /// on.
    bool Advance = true;
    /// Whether a frame that waits is followed by others, so that it should prefetch as well. Default off.
    bool MoreFrames = false;
    /// Bytes on the GPU at most; what the coarsest cut takes is the least limit there is. Default 512 MiB.
    std::uint64_t GraphicsMemoryLimit = std::uint64_t(512) << 20;
    /// Bytes in main memory at most. Another limit than before gives patches that did not fit another try.
    std::size_t PatchMemoryLimit = vtkMTPatchCache::DefaultLimit;
  };

  vtkMTFrame();
  ~vtkMTFrame();
  vtkMTFrame(const vtkMTFrame&) = delete;
  vtkMTFrame& operator=(const vtkMTFrame&) = delete;

  /// Forgets everything when the source is another one, and gives true then. Null is no source.
  bool SetSource(const std::shared_ptr<const vtkMTPatchSource>& source, const vtkMTPatchLoader::Settings& loader);
  const std::shared_ptr<const vtkMTPatchSource>& GetSource() const { return this->Cuts.GetSource(); }
  /// As far as it is known.
  const vtkMTGraph& GetGraph() const;
  /// Of the source's finest level.
  std::uint64_t GetNumberOfFinestTriangles() const { return this->FinestTriangles; }

  /**
   * What a pass draws in a renderer, as one sees it through one view or more at once: the arcs of the result, whose
   * patches are on the GPU unless they cannot be read. There must be a source.
   */
  const Result& Update(Key renderer, const std::vector<vtkMTView>& views, const Settings& settings, vtkMTUploader&);

  /// The renderer is no more.
  void Forget(Key renderer);

  /// The patches that could not be read or drawn since the last call: each is named once, with the source.
  std::vector<std::string> TakeFailures();

  /// What Update gave last, or null.
  const Result* GetLast() const { return this->Cuts.GetLast().get(); }
  /// Cuts that were looked for so far, and seconds that the last one took.
  std::uint64_t GetNumberOfCuts() const { return this->Cuts.GetNumberOfSearches(); }
  double GetCutTime() const { return this->Cuts.GetCutTime(); }
  /// The patches in main memory, or null where there is no source.
  vtkMTPatchCache* GetCache() const { return this->Cache.get(); }

private:
  // What was all on the GPU when it was last looked at; as long as that is the same, there is nothing to do.
  struct State
  {
    vtkMTRendererCuts::ResultPointer Cut;
    const vtkMTUploader* Uploader = nullptr;
    std::uint64_t Changes = 0;
    std::uint64_t Limit = 0;
    bool operator==(const State& other) const
    {
      return this->Cut == other.Cut && this->Uploader == other.Uploader && this->Changes == other.Changes &&
        this->Limit == other.Limit;
    }
  };

  struct Renderer
  {
    State AllThere;
    vtkMTRendererCuts::ResultPointer Drawn; // last
    const vtkMTUploader* Uploader = nullptr;
    std::uint64_t Time = 0;   // of its last frame
    std::uint64_t Before = 0; // of the one before
  };

  void Begin(Renderer& renderer, const Settings& settings);
  void FindCut(Key renderer, const std::vector<vtkMTView>& views, const Settings& settings);
  vtkMTCutFollower::Settings GetCutSettings(const Settings& settings) const;
  std::vector<const Renderer*> GetOthers() const;
  State GetState() const;
  bool UploadCut();
  bool BringPatch(std::size_t index, bool& complete);
  bool IsWaitedFor(std::uint32_t arc) const;
  std::shared_ptr<const vtkMTPatch> FetchPatch(std::size_t index);
  void BeginUpload();
  void UploadEarlyPatches();
  bool IsUploaded() const;
  bool DrawLess();
  bool GiveUp(std::uint32_t arc);
  void NoteFailures();

  vtkMTRendererCuts Cuts;
  std::unique_ptr<vtkMTPatchCache> Cache;
  std::map<Key, Renderer> Renderers;
  std::vector<std::string> Failures;
  std::uint64_t FinestTriangles = 0;
  bool GraphFailed = false; // and that has been noted
  std::uint64_t Time = 0;   // counts frames
  bool Wait = false;        // this frame waits for what it draws

  // Of the pass.
  vtkMTUploader* Uploader = nullptr;
  Renderer* Current = nullptr;
  vtkMTRendererCuts::ResultPointer Cut;
  std::uint64_t Limit = 0;         // bytes on the GPU
  std::uint64_t LessTriangles = 0; // a limit for the next cut: the last one had no room on the GPU
  bool CoarsestOnly = false;       // nothing else has room
};

#endif
