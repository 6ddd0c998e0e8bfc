// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper: draw calls and picking.
#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkMTPalette.h"
#include "vtkMTPatchAttributes.h"
#include "vtkMTSelectionIds.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationMapperInternals.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include "vtk_glew.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace
{
// The attribute that a patch's own colour takes the place of.
constexpr const char* ColorAttribute = "scalarColor";

const void* ToPointer(std::uint64_t offset)
{
  return reinterpret_cast<const void*>(static_cast<std::uintptr_t>(offset));
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
  self.Timer.ReusableStart();
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
  self.Timer.ReusableStop();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  self.CallSeconds = seconds.count();
  this->TimeToDraw = std::max<double>(seconds.count(), self.Timer.GetReusableElapsedSeconds());
  self.DrawSeconds += this->TimeToDraw;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::DrawPrimitives(
  vtkRenderer* renderer, vtkActor* actor, vtkOpenGLHelper& cellBO, unsigned int mode)
{
  Internals& self = *this->Implementation;
  vtkOpenGLBufferObject* indices = self.Arena.GetBuffer(vtkMTPatchStreams::Indices);
  if (self.Cut->Arcs.empty() || !indices || indices->GetHandle() == 0)
  {
    return;
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
  const bool oneColor = self.Plan.Coloring == vtkMTPatchStreams::OneColor;
  self.Arena.Bind(cellBO.Program, this->ColorBy != NONE || oneColor ? ColorAttribute : "");
  if (oneColor)
  {
    const GLint color = glGetAttribLocation(static_cast<GLuint>(cellBO.Program->GetHandle()), ColorAttribute);
    if (color >= 0)
    {
      glVertexAttrib4Nubv(static_cast<GLuint>(color), self.FieldColor.data());
    }
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLuint>(indices->GetHandle()));
  if (this->ColorBy != NONE || cellBO.Program->IsUniformUsed("PrimitiveIDOffset"))
  {
    this->DrawOneByOne(cellBO, mode);
  }
  else
  {
    this->DrawAtOnce(mode);
  }
  vtkMTPatchArena::Unbind();
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::DrawAtOnce(unsigned int mode)
{
  const Internals& self = *this->Implementation;
  const auto perTriangle = static_cast<std::uint64_t>(self.GetIndicesPerTriangle());
  const auto bytesPerIndex = static_cast<std::uint64_t>(self.GetBytesPerIndex());
  const GLenum type = self.Plan.ShortIndices ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  std::vector<GLsizei> counts;
  std::vector<const void*> places;
  std::vector<GLint> bases;
  for (const std::uint32_t arc : self.Cut->Arcs)
  {
    if (const vtkMTPatchArena::Slot* slot = self.Arena.Find(arc))
    {
      counts.push_back(static_cast<GLsizei>(slot->Triangles * perTriangle));
      places.push_back(ToPointer(slot->FirstTriangle * perTriangle * bytesPerIndex));
      bases.push_back(static_cast<GLint>(slot->FirstVertex));
    }
  }
  glMultiDrawElementsBaseVertex(
    mode, counts.data(), type, places.data(), static_cast<GLsizei>(counts.size()), bases.data());
}

//------------------------------------------------------------------------------
// Where each patch has a colour of its own, or the shader needs to know where in the arena a triangle is.
void vtkMultiTriangulationMapper::DrawOneByOne(vtkOpenGLHelper& cellBO, unsigned int mode)
{
  const Internals& self = *this->Implementation;
  const auto perTriangle = static_cast<std::uint64_t>(self.GetIndicesPerTriangle());
  const auto bytesPerIndex = static_cast<std::uint64_t>(self.GetBytesPerIndex());
  const GLenum type = self.Plan.ShortIndices ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  const auto program = static_cast<GLuint>(cellBO.Program->GetHandle());
  const GLint offset = glGetUniformLocation(program, "PrimitiveIDOffset");
  const GLint color = this->ColorBy != NONE ? glGetAttribLocation(program, ColorAttribute) : -1;
  const std::uint64_t primitives = this->GetPrimitivesPerTriangle(mode);
  for (const std::uint32_t arc : self.Cut->Arcs)
  {
    const vtkMTPatchArena::Slot* slot = self.Arena.Find(arc);
    if (!slot)
    {
      continue;
    }
    glUniform1i(offset, static_cast<GLint>(slot->FirstTriangle * primitives));
    if (color >= 0)
    {
      glVertexAttrib4Nubv(static_cast<GLuint>(color), this->GetPatchColor(arc).data());
    }
    glDrawElementsBaseVertex(mode, static_cast<GLsizei>(slot->Triangles * perTriangle), type,
      ToPointer(slot->FirstTriangle * perTriangle * bytesPerIndex), static_cast<GLint>(slot->FirstVertex));
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::DrawVertices(vtkRenderer* renderer, vtkActor* actor)
{
  const Internals& self = *this->Implementation;
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  for (const std::uint32_t arc : self.Cut->Arcs)
  {
    if (const vtkMTPatchArena::Slot* slot = self.Arena.Find(arc))
    {
      firsts.push_back(static_cast<GLint>(slot->FirstVertex));
      counts.push_back(static_cast<GLsizei>(slot->Vertices));
    }
  }
  vtkOpenGLHelper& cellBO = this->Primitives[PrimitiveVertices];
  this->DrawingVertices = true;
  this->UpdateShaders(cellBO, renderer, actor);
  if (cellBO.Program && !firsts.empty())
  {
    this->Implementation->Arena.Bind(cellBO.Program, "");
    glMultiDrawArrays(GL_POINTS, firsts.data(), counts.data(), static_cast<GLsizei>(firsts.size()));
    vtkMTPatchArena::Unbind();
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
      return vtkMTPalette::ForError(
        vtkMTTargetCut::GetPixelError(self.Graph(), self.View, arc, vtkMTTargetCut::Distance), this->PixelError);
  }
}

//------------------------------------------------------------------------------
std::uint64_t vtkMultiTriangulationMapper::GetPrimitivesPerTriangle(unsigned int mode)
{
  const auto indices = static_cast<std::uint64_t>(this->Implementation->GetIndicesPerTriangle());
  return mode == GL_POINTS ? indices : mode == GL_LINES ? indices / 2 : indices / 3;
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
  const std::uint64_t triangles = self.Arena.GetTriangleCapacity() * self.GetIndicesPerTriangle();
  renderer->GetSelector()->UpdateMaximumPointId(static_cast<vtkIdType>(self.Arena.GetVertexCapacity()));
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
  int array = -1;
  if (points)
  {
    array = this->PointIdArrayName
      ? vtkMTPatchAttributes::FindArray(graph, this->PointIdArrayName, vtkMTArrayInfo::Point)
      : -1;
  }
  else
  {
    array = this->CellIdArrayName ? vtkMTPatchAttributes::FindArray(graph, this->CellIdArrayName, vtkMTArrayInfo::Cell)
                                  : vtkMTPatchAttributes::FindRole(graph, vtkMTArrayInfo::InputCellIds);
  }
  std::uint64_t primitives = 1;
  if (cells)
  {
    const int representation = static_cast<vtkActor*>(prop)->GetProperty()->GetRepresentation();
    primitives = this->GetPrimitivesPerTriangle(
      this->PointPicking ? GL_POINTS : static_cast<GLenum>(this->GetOpenGLMode(representation, PrimitiveTris)));
  }
  std::vector<unsigned char> arrays = self.Streams.GetArrays(graph);
  if (array >= 0)
  {
    arrays[array] = 1;
  }
  self.Cache->SetArrays(arrays);
  vtkMTSelectionIds ids(
    graph, self.Arena, *self.Cache, array, points ? vtkMTPatchArena::Vertices : vtkMTPatchArena::Triangles);
  ids.Translate(pixelOffsets, low, selector->GetRawPixelBuffer(highPass), primitives, pass == highPass, target);
}
