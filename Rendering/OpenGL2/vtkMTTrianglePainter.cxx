// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTrianglePainter.h"

#include "vtkMTGraph.h"
#include "vtkMTOpenGL.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkShaderProgram.h"

namespace
{
// The attribute that a patch's own colour takes the place of.
constexpr const char* ColorAttribute = "scalarColor";
}

void vtkMTTrianglePainter::Apply(const vtkMTGraph& graph, const vtkMTPatchStreams::Plan& plan, const void* user,
  const vtkMTPatchStreams::Mapping& mapping)
{
  this->Graph = &graph;
  this->Mapping = mapping;
  this->Streams.Apply(plan, user, this->Arena);
}

void vtkMTTrianglePainter::Clear()
{
  this->Arena.Clear();
  this->Streams.Clear();
}

vtkOpenGLBufferObject* vtkMTTrianglePainter::GetIndices()
{
  return this->Arena.GetBuffer(vtkMTPatchStreams::GetIndexStream(this->Streams.GetPlan()));
}

vtkMTUploader::Cost vtkMTTrianglePainter::GetCost() const
{
  return { static_cast<std::uint32_t>(this->Arena.GetBytesOf(1, 0)),
    static_cast<std::uint32_t>(this->Arena.GetBytesOf(0, 1)) };
}

std::vector<unsigned char> vtkMTTrianglePainter::GetArrays() const
{
  return this->Streams.GetArrays(*this->Graph);
}

bool vtkMTTrianglePainter::IsUploaded(std::uint32_t arc) const
{
  const vtkMTPatchArena::Slot* slot = this->Arena.Find(arc);
  return slot && !this->Streams.IsStale(this->Arena, *slot);
}

void vtkMTTrianglePainter::Begin(
  const std::vector<std::uint32_t>& drawn, const std::vector<std::uint32_t>& kept, std::uint64_t limit)
{
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  const auto touch = [&](const std::vector<std::uint32_t>& arcs)
  {
    for (const std::uint32_t arc : arcs)
    {
      vertices += this->Graph->Arcs[arc].Wedges;
      triangles += this->Graph->Arcs[arc].Triangles;
      this->Arena.Touch(arc);
    }
  };
  // The order in which room is made: what no renderer draws goes first, then what others draw.
  touch(kept);
  touch(drawn);
  this->Arena.SetLimit(limit);
  this->Arena.BeginFrame(vertices, triangles);
  for (const std::uint32_t arc : drawn)
  {
    if (this->Arena.Find(arc))
    {
      this->Reserve(arc);
    }
  }
}

bool vtkMTTrianglePainter::Reserve(std::uint32_t arc)
{
  const vtkMTArc& record = this->Graph->Arcs[arc];
  return this->Arena.Use(arc, record.Wedges, record.Triangles) != nullptr;
}

bool vtkMTTrianglePainter::Upload(std::uint32_t arc, const vtkMTPatch& patch)
{
  const vtkMTArc& record = this->Graph->Arcs[arc];
  vtkMTPatchArena::Slot* slot = this->Arena.Use(arc, record.Wedges, record.Triangles);
  return slot && this->Streams.Upload(this->Arena, *slot, *this->Graph, patch, this->Mapping);
}

bool vtkMTTrianglePainter::HasBuffers()
{
  vtkOpenGLBufferObject* indices = this->GetIndices();
  return indices && indices->GetHandle() != 0;
}

std::uint64_t vtkMTTrianglePainter::GetPrimitivesPerTriangle(unsigned int mode) const
{
  const std::uint64_t indices = this->GetIndicesPerTriangle();
  return mode == GL_POINTS ? indices : mode == GL_LINES ? indices / 2 : indices / 3;
}

unsigned int vtkMTTrianglePainter::GetIndexType() const
{
  return this->Streams.GetPlan().ShortIndices ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
}

// Where the slot's indices begin in their buffer, as OpenGL wants it.
const void* vtkMTTrianglePainter::GetPlace(const vtkMTPatchArena::Slot& slot) const
{
  const std::uint64_t bytesPerIndex = this->Streams.GetPlan().ShortIndices ? 2 : 4;
  return reinterpret_cast<const void*>(
    static_cast<std::uintptr_t>(slot.FirstTriangle * this->GetIndicesPerTriangle() * bytesPerIndex));
}

void vtkMTTrianglePainter::Draw(
  vtkShaderProgram* program, unsigned int mode, const std::vector<std::uint32_t>& arcs, const Colors& colors)
{
  this->Arena.Bind(program, colors.All || colors.OfPatch ? ColorAttribute : "");
  if (colors.All)
  {
    const GLint color = glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), ColorAttribute);
    if (color >= 0)
    {
      glVertexAttrib4Nubv(static_cast<GLuint>(color), colors.All->data());
    }
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLuint>(this->GetIndices()->GetHandle()));
  if (colors.OfPatch || program->IsUniformUsed("PrimitiveIDOffset"))
  {
    this->DrawOneByOne(program, mode, arcs, colors);
  }
  else
  {
    this->DrawAtOnce(mode, arcs);
  }
  vtkMTPatchArena::Unbind();
}

void vtkMTTrianglePainter::DrawAtOnce(unsigned int mode, const std::vector<std::uint32_t>& arcs)
{
  std::vector<GLsizei> counts;
  std::vector<const void*> places;
  std::vector<GLint> bases;
  for (const std::uint32_t arc : arcs)
  {
    if (const vtkMTPatchArena::Slot* slot = this->Arena.Find(arc))
    {
      counts.push_back(static_cast<GLsizei>(slot->Triangles * this->GetIndicesPerTriangle()));
      places.push_back(this->GetPlace(*slot));
      bases.push_back(static_cast<GLint>(slot->FirstVertex));
    }
  }
  glMultiDrawElementsBaseVertex(
    mode, counts.data(), this->GetIndexType(), places.data(), static_cast<GLsizei>(counts.size()), bases.data());
}

// Where each patch has a colour of its own, or the shader needs to know where in the arena a triangle is.
void vtkMTTrianglePainter::DrawOneByOne(
  vtkShaderProgram* program, unsigned int mode, const std::vector<std::uint32_t>& arcs, const Colors& colors)
{
  const auto handle = static_cast<GLuint>(program->GetHandle());
  const GLint offset = glGetUniformLocation(handle, "PrimitiveIDOffset");
  const GLint color = colors.OfPatch ? glGetAttribLocation(handle, ColorAttribute) : -1;
  const std::uint64_t primitives = this->GetPrimitivesPerTriangle(mode);
  for (const std::uint32_t arc : arcs)
  {
    const vtkMTPatchArena::Slot* slot = this->Arena.Find(arc);
    if (!slot)
    {
      continue;
    }
    glUniform1i(offset, static_cast<GLint>(slot->FirstTriangle * primitives));
    if (color >= 0)
    {
      glVertexAttrib4Nubv(static_cast<GLuint>(color), colors.OfPatch(arc).data());
    }
    glDrawElementsBaseVertex(mode, static_cast<GLsizei>(slot->Triangles * this->GetIndicesPerTriangle()),
      this->GetIndexType(), this->GetPlace(*slot), static_cast<GLint>(slot->FirstVertex));
  }
}

void vtkMTTrianglePainter::DrawVertices(vtkShaderProgram* program, const std::vector<std::uint32_t>& arcs)
{
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  for (const std::uint32_t arc : arcs)
  {
    if (const vtkMTPatchArena::Slot* slot = this->Arena.Find(arc))
    {
      firsts.push_back(static_cast<GLint>(slot->FirstVertex));
      counts.push_back(static_cast<GLsizei>(slot->Vertices));
    }
  }
  if (firsts.empty())
  {
    return;
  }
  this->Arena.Bind(program, "");
  glMultiDrawArrays(GL_POINTS, firsts.data(), counts.data(), static_cast<GLsizei>(firsts.size()));
  vtkMTPatchArena::Unbind();
}
