// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCutKeeper
 * @brief one cut per renderer and view: what is drawn, kept while nothing changes
 *
 * Every pass of a frame (opaque, translucent, depth peeling, selection) asks again; as long as view and settings are
 * the same, so is the answer, without work. Patches that cannot be read count as not resident, so the coarser ones stay
 * in the cut.
 */
#ifndef vtkMTCutKeeper_h
#define vtkMTCutKeeper_h

#include "vtkMTExtraction.h"
#include "vtkMTView.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <list>
#include <memory>
#include <vector>

class vtkMTPatchSource;
class vtkRenderer;

class vtkMTCutKeeper
{
public:
  /// Forgets all cuts when the source is another one.
  bool SetSource(const std::shared_ptr<const vtkMTPatchSource>& source);
  const std::shared_ptr<const vtkMTPatchSource>& GetSource() const { return this->Source; }

  /// What to draw. With `freeze`, the cut that the renderer had before, seen from the new view.
  const vtkMTExtraction::Result& Update(
    vtkRenderer* renderer, const vtkMTView& view, const vtkMTExtraction::Settings& settings, bool freeze);

  /// True the first time.
  bool MarkUnreadable(std::uint32_t arc);

  /// What Update gave last, or null.
  const vtkMTExtraction::Result* GetLast() const { return this->Last.get(); }
  /// Seconds that the last new cut took.
  double GetCutTime() const { return this->CutTime; }

private:
  struct Kept
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkMTView View;
    vtkMTExtraction::Settings Settings;
    bool Frozen = false;
    std::uint64_t Readable = 0;
    std::shared_ptr<vtkMTExtraction::Result> Result;
  };

  Kept& Find(vtkRenderer* renderer);

  std::shared_ptr<const vtkMTPatchSource> Source;
  vtkMTExtraction Extraction;
  std::list<Kept> All;
  std::vector<unsigned char> Resident;
  std::uint64_t ReadableRevision = 0;
  std::shared_ptr<vtkMTExtraction::Result> Last;
  double CutTime = 0.0;
};

#endif
