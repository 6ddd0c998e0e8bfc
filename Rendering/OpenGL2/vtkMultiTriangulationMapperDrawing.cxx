// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper: draw calls and picking.
#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkMTOpenGL.h"
#include "vtkMTPalette.h"
#include "vtkMTPatchAttributes.h"
#include "vtkMTSelectionIds.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationMapperInternals.h"
#include "vtkOpenGLRenderTimer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace
{
// The array whose values the selector's ids of points or cells are, or -1.
int FindIds(const vtkMTGraph& graph, bool points, const char* pointIds, const char* cellIds)
{
  if (points)
  {
    return pointIds ? vtkMTPatchAttributes::FindArray(graph, pointIds, vtkMTArrayInfo::Point) : -1;
  }
  return cellIds ? vtkMTPatchAttributes::FindArray(graph, cellIds, vtkMTArrayInfo::Cell)
                 : vtkMTPatchAttributes::FindRole(graph, vtkMTArrayInfo::InputCellIds);
}
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->HasPatches())
  {
    this->Superclass::RenderPieceDraw(renderer, actor);
    return;
  }
  vtkProperty* property = actor->GetProperty();
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
  if (renderer->GetUseImageBasedLighting() && renderer->GetEnvironmentTexture())
  {
    state->vtkglEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  }
  this->DrawingVertices = false;
  this->DrawingSelection = false;
  Internals& self = *this->Implementation;
  const auto start = std::chrono::steady_clock::now();
  vtkOpenGLRenderTimer& timer = self.Painters.GetTimer(renderer->GetRenderWindow());
  timer.ReusableStart();
  GLenum mode = static_cast<GLenum>(this->GetOpenGLMode(property->GetRepresentation(), PrimitiveTris));
  if (this->PointPicking)
  {
    state->vtkglPointSize(static_cast<float>(this->GetPointPickingPrimitiveSize(PrimitiveTris)));
    mode = GL_POINTS;
  }
  // A frame that mirrors turns the triangles, so that their front stays the front.
  glFrontFace(self.Placement.IsMirrored() ? GL_CW : GL_CCW);
  this->DrawPrimitives(renderer, actor, this->Primitives[PrimitiveTris], mode);
  glFrontFace(GL_CCW);

  const bool withEdges = property->GetEdgeVisibility() && property->GetRepresentation() == VTK_SURFACE;
  if (withEdges && property->GetVertexVisibility() && !renderer->GetSelector())
  {
    this->DrawVertices(renderer, actor);
  }
  // Where the CPU draws, its clock says more; where a GPU does, its own.
  timer.ReusableStop();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  self.CallSeconds = seconds.count();
  this->TimeToDraw = std::max<double>(seconds.count(), timer.GetReusableElapsedSeconds());
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::DrawPrimitives(
  vtkRenderer* renderer, vtkActor* actor, vtkOpenGLHelper& cellBO, unsigned int mode)
{
  Internals& self = *this->Implementation;
  if (self.GetDrawnArcs().empty() || !self.Painter->HasBuffers())
  {
    return;
  }
  if (self.HasCellTextures)
  {
    self.CellTextureBuffer->Activate();
  }
  this->UpdateShaders(cellBO, renderer, actor);
  if (!cellBO.Program)
  {
    return;
  }
  if (mode == GL_LINES && !this->HaveWideLines(renderer, actor))
  {
    static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())
      ->GetState()
      ->vtkglLineWidth(actor->GetProperty()->GetLineWidth());
  }
  vtkMTTrianglePainter::Colors colors;
  colors.All = self.Plan.Coloring == vtkMTPatchStreams::OneColor ? &self.FieldColor : nullptr;
  if (this->ShowsCut())
  {
    colors.OfPatch = [this](std::uint32_t arc) { return this->GetPatchColor(arc); };
  }
  self.Painter->Draw(cellBO.Program, mode, self.GetDrawnArcs(), colors);
  if (self.HasCellTextures)
  {
    self.CellTextureBuffer->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::DrawVertices(vtkRenderer* renderer, vtkActor* actor)
{
  vtkOpenGLHelper& cellBO = this->Primitives[PrimitiveVertices];
  this->DrawingVertices = true;
  this->UpdateShaders(cellBO, renderer, actor);
  if (cellBO.Program)
  {
    this->Implementation->Painter->DrawVertices(cellBO.Program, this->Implementation->GetDrawnArcs());
  }
  this->DrawingVertices = false;
}

//------------------------------------------------------------------------------
std::array<unsigned char, 4> vtkMultiTriangulationMapper::GetPatchColor(std::uint32_t arc)
{
  const Internals& self = *this->Implementation;
  switch (this->ColorBy)
  {
    case LEVEL:
      return vtkMTPalette::ForLevel(self.Graph().GetLevelOfArc(arc));
    case PATCH:
      return vtkMTPalette::ForPatch(arc);
    default:
      break;
  }
  double error = 0.0;
  for (const vtkMTView& view : self.Views)
  {
    error = std::max(error, vtkMTTargetCut::GetPixelError(self.Graph(), view, arc, vtkMTTargetCut::Distance));
  }
  return vtkMTPalette::ForError(error, this->PixelError);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  const double drawing = this->TimeToDraw;
  this->Superclass::RenderPieceFinish(renderer, actor);
  if (this->HasPatches())
  {
    this->TimeToDraw = drawing; // the superclass measures polydata of many cells only
  }
  this->FrameTime =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Implementation->FrameStart).count();
  this->OverheadTime = this->FrameTime - this->Implementation->CallSeconds;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::UpdateMaximumPointCellIds(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->HasPatches())
  {
    this->Superclass::UpdateMaximumPointCellIds(renderer, actor);
    return;
  }
  // What the shader writes, and what is put in its place.
  const Internals& self = *this->Implementation;
  const vtkMTPatchArena& arena = self.Painter->GetArena();
  const std::uint64_t triangles = arena.GetTriangleCapacity() * self.Painter->GetIndicesPerTriangle();
  renderer->GetSelector()->UpdateMaximumPointId(static_cast<vtkIdType>(arena.GetVertexCapacity()));
  renderer->GetSelector()->UpdateMaximumCellId(
    static_cast<vtkIdType>(std::max(triangles, self.Graph().InputCounts.Triangles)));
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& pixelOffsets, vtkProp* prop)
{
  if (!this->HasPatches())
  {
    this->Superclass::ProcessSelectorPixelBuffers(selector, pixelOffsets, prop);
    return;
  }
  Internals& self = *this->Implementation;
  const int pass = selector->GetCurrentPass();
  const bool points = pass == vtkHardwareSelector::POINT_ID_LOW24 || pass == vtkHardwareSelector::POINT_ID_HIGH24;
  const bool cells = pass == vtkHardwareSelector::CELL_ID_LOW24 || pass == vtkHardwareSelector::CELL_ID_HIGH24;
  if (!this->PopulateSelectionSettings || !(points || cells))
  {
    return;
  }
  const int lowPass = points ? vtkHardwareSelector::POINT_ID_LOW24 : vtkHardwareSelector::CELL_ID_LOW24;
  const int highPass = points ? vtkHardwareSelector::POINT_ID_HIGH24 : vtkHardwareSelector::CELL_ID_HIGH24;
  const unsigned char* low = selector->GetRawPixelBuffer(lowPass);
  unsigned char* target = selector->GetPixelBuffer(pass);
  if (!low || !target)
  {
    return;
  }
  const vtkMTGraph& graph = self.Graph();
  const int array = FindIds(graph, points, this->PointIdArrayName, this->CellIdArrayName);
  std::uint64_t primitives = 1;
  if (cells)
  {
    const int representation = static_cast<vtkActor*>(prop)->GetProperty()->GetRepresentation();
    primitives = self.Painter->GetPrimitivesPerTriangle(
      this->PointPicking ? GL_POINTS : static_cast<GLenum>(this->GetOpenGLMode(representation, PrimitiveTris)));
  }
  std::vector<unsigned char> arrays = self.Painter->GetArrays();
  if (array >= 0)
  {
    arrays[array] = 1;
  }
  vtkMTPatchCache& cache = *self.Frame.GetCache();
  cache.SetArrays(arrays);
  vtkMTSelectionIds ids(
    graph, self.Painter->GetArena(), cache, array, points ? vtkMTPatchArena::Vertices : vtkMTPatchArena::Triangles);
  ids.Translate(pixelOffsets, low, selector->GetRawPixelBuffer(highPass), primitives, pass == highPass, target);
}
