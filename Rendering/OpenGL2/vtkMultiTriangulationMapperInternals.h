// SPDX-License-Identifier: BSD-3-Clause
// What vtkMultiTriangulationMapper keeps between frames; for its own sources.
#ifndef vtkMultiTriangulationMapperInternals_h
#define vtkMultiTriangulationMapperInternals_h

#include "vtkActor.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchArena.h"
#include "vtkMTPatchCache.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPatchStreams.h"
#include "vtkMTPlacement.h"
#include "vtkMTRendererCuts.h"
#include "vtkMTView.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderTimer.h"
#include "vtkPolyData.h"
#include "vtkStateStorage.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>

struct vtkMultiTriangulationMapper::Internals
{
  vtkNew<vtkPolyData> Template; // one point without cells: makes the superclass build the shaders
  vtkMTRendererCuts Keeper;
  std::unique_ptr<vtkMTPatchCache> Cache;
  vtkMTPatchArena Arena;
  vtkMTPatchStreams Streams;
  vtkMTPatchStreams::Plan Plan;
  std::array<unsigned char, 4> FieldColor{ 255, 255, 255, 255 }; // of everything, where Plan says so
  vtkStateStorage ColorState;
  vtkStateStorage NewColorState;
  bool DrewPatches = false;

  vtkMTView View;
  const vtkMTCutFollower::Result* Cut = nullptr;
  vtkMTRendererCuts::Frame Frame;
  bool Wait = false;                             // this frame waits for what it draws
  std::array<std::int32_t, 3> Origin{ 0, 0, 0 }; // the lattice point that the GPU's coordinates are relative to
  std::chrono::steady_clock::time_point FrameStart;

  std::uint64_t Triangles = 0;                         // of all patches of the source
  std::array<double, 6> Bounds{ 0, -1, 0, -1, 0, -1 }; // of the model
  std::weak_ptr<const vtkMTPatchSource> BoundsSource;  // which they were found for
  vtkOpenGLRenderTimer Timer;                          // of draw calls, on the GPU
  double CallSeconds = 0.0;                            // until this pass's draw calls had returned
  double DrawSeconds = 0.0;                            // of this frame's draw calls so far, all passes
  double MeasuredRate = 0.0;                           // triangles per second
  // What was all on the GPU when it was last looked at; as long as that is the same, there is nothing to do.
  struct Uploaded
  {
    const vtkMTCutFollower::Result* Cut = nullptr;
    std::uint64_t Searches = 0;
    std::uint64_t ArenaChanges = 0;
    std::uint64_t GraphicsLimit = 0;
    bool operator==(const Uploaded& other) const
    {
      return this->Cut == other.Cut && this->Searches == other.Searches && this->ArenaChanges == other.ArenaChanges &&
        this->GraphicsLimit == other.GraphicsLimit;
    }
  };
  Uploaded LastUpload;

  vtkMTPlacement Placement; // the input's frame

  std::uint64_t LessTriangles = 0; // a limit for the next cut: the last one did not fit into the arena

  const vtkMTGraph& Graph() const { return this->Keeper.GetSource()->GetGraph(); }
  /// Row-major: the input's frame, and then the actor's matrix.
  std::array<double, 16> GetModelToWorld(vtkActor* actor) const
  {
    vtkMTPlacement sum = this->Placement;
    sum.Append(actor->GetMatrix()->GetData());
    return sum.Matrix;
  }
  int GetIndicesPerTriangle() const { return this->Plan.Edges ? 6 : 3; }
  int GetBytesPerIndex() const { return this->Plan.ShortIndices ? 2 : 4; }
};

#endif
