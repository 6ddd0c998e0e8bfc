// SPDX-License-Identifier: BSD-3-Clause
// What vtkMultiTriangulationMapper keeps between frames; for its own sources.
#ifndef vtkMultiTriangulationMapperInternals_h
#define vtkMultiTriangulationMapperInternals_h

#include "vtkActor.h"
#include "vtkMTFrame.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPatchStreams.h"
#include "vtkMTPlacement.h"
#include "vtkMTSelectionIds.h"
#include "vtkMTTrianglePainter.h"
#include "vtkMTView.h"
#include "vtkMTWindowClock.h"
#include "vtkMTWindowPainters.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkStateStorage.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <vector>

struct vtkMultiTriangulationMapper::Internals
{
  vtkNew<vtkPolyData> Template; // one point without cells: makes the superclass build the shaders
  vtkMTFrame Frame;
  vtkMTWindowPainters Painters;
  vtkMTTrianglePainter* Painter = nullptr; // of the window that is being drawn
  std::weak_ptr<vtkMTWindowClock> Clock;   // likewise
  bool KeepsPatches = false;               // where the superclass's resources are released
  bool DrewPatches = false;

  vtkMTPatchStreams::Plan Plan;
  std::vector<vtkMTPatchStreams::CellTexture> CellTextures;      // as they were asked for
  vtkNew<vtkTextureObject> CellTextureBuffer;                    // which of them each triangle has
  bool HasCellTextures = false;                                  // in this pass
  std::array<unsigned char, 4> FieldColor{ 255, 255, 255, 255 }; // of everything, where Plan says so
  // How values become colours.
  enum ConversionType
  {
    Mapped, // as VTK does it
    Named,  // by a table of values that have names and colours
    Direct, // they are colours
    ByPlace // by elevation
  };
  ConversionType Conversion = Mapped;
  double FullColor = 255.0;
  std::string ForeignArrays; // that were warned of
  std::string ScaleProblem;  // that was told
  vtkStateStorage ColorState;
  vtkStateStorage NewColorState;

  std::array<vtkMTSelectionIds::Memory, 2> SelectedIds; // of points and of cells
  std::vector<vtkMTView> Views;
  const vtkMTFrame::Result* Cut = nullptr; // what this pass shows
  std::vector<std::uint32_t> Share;        // of its arcs, what this process draws, where it draws a share
  std::uint64_t ShareTriangles = 0;
  bool DrawsShare = false;
  std::vector<std::array<double, 4>> Planes;     // that clip, as equations in steps of the lattice
  std::array<std::int32_t, 3> Origin{ 0, 0, 0 }; // the lattice point that the GPU's coordinates are relative to
  std::chrono::steady_clock::time_point FrameStart;
  double CallSeconds = 0.0; // until this pass's draw calls had returned

  vtkMTPlacement Placement;                            // the input's frame
  std::array<double, 6> Bounds{ 0, -1, 0, -1, 0, -1 }; // of the model on the lattice
  std::weak_ptr<const vtkMTPatchSource> BoundsSource;  // which they were found for

  // An actor in a renderer: what the frame keeps a cut for.
  struct Seen
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWeakPointer<vtkActor> Actor;
  };
  std::list<Seen> AllSeen;

  const vtkMTGraph& Graph() const { return this->Frame.GetGraph(); }

  void TakeShare(const int share[2]);
  bool IsClippedAway(const vtkMTBox& box) const;
  const std::vector<std::uint32_t>& GetDrawnArcs() const { return this->DrawsShare ? this->Share : this->Cut->Arcs; }

  // Of some arcs, where the input stands.
  double GetLargest(const std::vector<std::uint32_t>& arcs, double (vtkMTGraph::*distance)(std::uint32_t) const) const
  {
    double largest = 0.0;
    for (const std::uint32_t arc : arcs)
    {
      largest = std::max(largest, (this->Graph().*distance)(arc));
    }
    return largest * this->Placement.GetStretch();
  }

  // Row-major: the input's frame, and then the actor's matrix.
  std::array<double, 16> GetModelToWorld(vtkActor* actor) const
  {
    vtkMTPlacement sum = this->Placement;
    sum.Append(actor->GetMatrix()->GetData());
    return sum.Matrix;
  }

  // On the lattice, wherever the input's frame puts it. Asked several times a frame, and to be found from all arcs.
  const std::array<double, 6>& GetBounds(const std::shared_ptr<const vtkMTPatchSource>& source)
  {
    if (this->BoundsSource.lock() != source)
    {
      this->BoundsSource = source;
      source->GetKnownGraph().GetBounds(this->Bounds.data());
    }
    return this->Bounds;
  }

  vtkMTFrame::Key GetKey(vtkRenderer* renderer, vtkActor* actor)
  {
    const Seen* key = nullptr;
    for (auto seen = this->AllSeen.begin(); seen != this->AllSeen.end();)
    {
      if (!seen->Renderer || !seen->Actor)
      {
        this->Frame.Forget(&*seen);
        seen = this->AllSeen.erase(seen);
        continue;
      }
      key = seen->Renderer == renderer && seen->Actor == actor ? &*seen : key;
      ++seen;
    }
    if (!key)
    {
      this->AllSeen.push_back({ renderer, actor });
      key = &this->AllSeen.back();
    }
    return key;
  }
};

#endif
