// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper: draw calls.
#include "vtkActor.h"
#include "vtkMTOpenGL.h"
#include "vtkMTPalette.h"
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
